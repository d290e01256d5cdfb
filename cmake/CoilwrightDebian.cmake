# Debian packages of an install, by `cpack` (scripts/package.sh): coilwright, with programs, manual pages, completion and
# input files; coilwright-dev, with libraries, headers and their CMake configuration; and coilwright-films, the module that
# reads films, since it brings OpenCV. What programs depend on is read from what they link; what a user of the libraries
# needs to compile is said here, and tests/package/empty_root.sh finds what is missing.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The maintainers of Coilwright")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME coilwright)
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "It sizes soft electromagnetic bending actuators
 and identifies, from measured motion, which physical effect a model lacks.")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "coilwright-films, nodejs")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME coilwright-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(JOIN coilwright_debian_packages ", " development_packages)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "coilwright (= ${PROJECT_VERSION}), ${development_packages}")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Libraries, headers and CMake configuration
 for programs in C++ that use Coilwright.")
if(TARGET coilwright_opencv)
  list(APPEND CPACK_COMPONENTS_ALL films)
  set(CPACK_DEBIAN_FILMS_PACKAGE_NAME coilwright-films)
  set(CPACK_DEBIAN_FILMS_PACKAGE_DEPENDS "coilwright (= ${PROJECT_VERSION})")
  set(CPACK_COMPONENT_FILMS_DESCRIPTION "Reads films of a finger for Coilwright
 with the libraries of OpenCV.")
endif()
include(CPack)

if(COILWRIGHT_TESTS)
  add_test(NAME packages_in_an_empty_root COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/tests/package/empty_root.sh ${PROJECT_BINARY_DIR})
  set_tests_properties(packages_in_an_empty_root PROPERTIES SKIP_RETURN_CODE 77 LABELS long)
endif()
