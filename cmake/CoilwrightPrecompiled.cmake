# coilwright_precompile(<target> [TEST] [HEADERS <header>...])
#
# Lets a target start from headers that were parsed once for the whole build. Nobody includes by this: every file names
# what it uses, and what has COILWRIGHT_PCH=OFF (preset clang; clang-tidy, which .ci/run asks about every source that
# changed) fails where one does not. HEADERS: what this target alone includes everywhere; it then has a precompiled
# header of its own.
option(COILWRIGHT_PCH "Precompile the heaviest headers of other projects" ${PROJECT_IS_TOP_LEVEL})

# What a twentieth of the files or more includes, by itself or by another.
set(precompiled_everywhere
  <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <filesystem> <functional> <iostream> <limits> <map>
  <memory> <numbers> <numeric> <optional> <random> <set> <span> <stdexcept> <string> <string_view> <utility> <variant>
  <vector> <Eigen/Core>)
set(precompiled_in_rooms <Eigen/Cholesky> <fmt/format.h> <fmt/ranges.h>)

# A library that does nothing but own the precompiled header. GCC takes one only under the flags it was made with
# (position-independent code or not, macros, even -Wpedantic for a macro of its own), so its users have these in common.
function(coilwright_precompiled name)
  cmake_parse_arguments(PCH "" "PIC" "HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ${PCH_PIC})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen ${PCH_LINK})
  coilwright_warnings(${name})
  target_precompile_headers(${name} PRIVATE ${precompiled_everywhere} ${PCH_HEADERS})
endfunction()

if(COILWRIGHT_PCH)
  coilwright_precompiled(coilwright_precompiled PIC ON
    HEADERS ${precompiled_in_rooms} LINK fmt::fmt)
  if(COILWRIGHT_TESTS)
    coilwright_precompiled(coilwright_precompiled_tests PIC OFF
      HEADERS <gmock/gmock.h> <gtest/gtest.h> LINK GTest::gtest GTest::gmock)
  endif()
endif()

function(coilwright_precompile target)
  cmake_parse_arguments(PCH "TEST" "" "HEADERS" ${ARGN})
  if(NOT COILWRIGHT_PCH)
    return()
  endif()
  if(PCH_HEADERS)
    target_precompile_headers(${target} PRIVATE ${precompiled_everywhere} ${precompiled_in_rooms} ${PCH_HEADERS})
  elseif(PCH_TEST)
    target_precompile_headers(${target} REUSE_FROM coilwright_precompiled_tests)
  else()
    target_precompile_headers(${target} REUSE_FROM coilwright_precompiled)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
  # for a compiler that parses the header after all
  target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
