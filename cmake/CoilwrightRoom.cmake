# coilwright_room(<name> SOURCES <file>... [PUBLIC <target>...] [PRIVATE <target>...])
#
# One library a room. Its link list is the architecture: a room may link only rooms that stand above it
# (tests/layering_test.py checks the includes against the same order).
function(coilwright_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target coilwright_${name})
  add_library(${target} STATIC ${ROOM_SOURCES})
  add_library(coilwright::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE})
  coilwright_warnings(${target})
  coilwright_precompile(${target})
  coilwright_unity(${target})
  coilwright_component(${name})
endfunction()

# Compiles the files of a room, or of a program of tests, as one, in the builds that users and continuous integration
# make: what they include is parsed once, and what its templates need is made once, which is most of what a file takes.
# Names in unnamed namespaces are therefore different throughout it. The other presets compile each file alone, which
# shows what a file forgets to include.
option(COILWRIGHT_UNITY "Compile the files of a library or a program of tests together" OFF)
function(coilwright_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${COILWRIGHT_UNITY} UNITY_BUILD_BATCH_SIZE 0)
  if(COILWRIGHT_UNITY)
    # GCC takes the file that includes the others for a source and these for headers, whose unnamed namespaces it warns of;
    # a local name of one file shadows a name of another, which is no fault. The builds that compile each file alone keep
    # both warnings whole.
    target_compile_options(${target} PRIVATE -Wno-shadow
      $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wshadow=local>)
  endif()
endfunction()

# coilwright_component(<name>): the library coilwright_<name> is a component of the installed package. It links only
# components that were added before.
function(coilwright_component name)
  set_property(GLOBAL APPEND PROPERTY COILWRIGHT_COMPONENTS ${name})
  install(TARGETS coilwright_${name} EXPORT coilwright-${name} COMPONENT development)
endfunction()

# Warnings are ours, never a consumer's: private, and errors only where COILWRIGHT_WERROR says so (CI).
option(COILWRIGHT_WERROR "Treat warnings as errors" OFF)
function(coilwright_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<BOOL:${COILWRIGHT_WERROR}>:-Werror>)
endfunction()

# coilwright_test(<name> SOURCES <file>... LINK <target>... [LABEL <label>] [LONG <test>...])
#
# Label unit: seconds, and a minute under the sanitizers. What takes longer has a label of its own. LONG: tests, as
# GoogleTest filters them, that take half a minute or more each and have shorter ones beside them; their label is long,
# and `scripts/test.sh` leaves them out but for `--long`.
function(coilwright_test name)
  cmake_parse_arguments(TEST "" "LABEL" "SOURCES;LINK;LONG" ${ARGN})
  if(NOT TEST_LABEL)
    set(TEST_LABEL unit)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    COILWRIGHT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    COILWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  coilwright_warnings(${name})
  coilwright_precompile(${name} TEST)
  coilwright_unity(${name})
  list(JOIN TEST_LONG ":" long)
  if(long)
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${long}" TEST_LIST ${name}_long
                         PROPERTIES LABELS long)
    set(others TEST_FILTER "-${long}")
  endif()
  # What takes up to a minute begins before what takes none, so that it does not run alone at the end.
  set(begins "")
  if(NOT TEST_LABEL STREQUAL unit)
    set(begins COST 40)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST ${others} PROPERTIES LABELS ${TEST_LABEL} ${begins})
endfunction()
