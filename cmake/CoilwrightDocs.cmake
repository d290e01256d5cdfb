# Target `docs`: the API reference of the public headers, where Doxygen is installed. Nothing else needs it.
find_package(Doxygen 1.9 QUIET)
if(NOT DOXYGEN_FOUND)
  if(COILWRIGHT_TESTS)
    add_test(NAME api_reference COMMAND ${CMAKE_COMMAND} -E echo "left out: it needs Doxygen (scripts/setup.sh ci)")
    set_tests_properties(api_reference PROPERTIES SKIP_REGULAR_EXPRESSION "left out")
  endif()
  return()
endif()
configure_file(docs/Doxyfile.in docs/Doxyfile @ONLY)
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -DDOXYGEN=${DOXYGEN_EXECUTABLE} -DFOLDER=${PROJECT_BINARY_DIR}/docs
          -P ${PROJECT_SOURCE_DIR}/cmake/RunDoxygen.cmake
  COMMENT "API reference in ${PROJECT_BINARY_DIR}/docs/html"
  VERBATIM)
if(COILWRIGHT_TESTS)
  add_test(NAME api_reference
           COMMAND ${CMAKE_COMMAND} -DDOXYGEN=${DOXYGEN_EXECUTABLE} -DFOLDER=${PROJECT_BINARY_DIR}/docs
                   -P ${PROJECT_SOURCE_DIR}/cmake/RunDoxygen.cmake)
endif()
