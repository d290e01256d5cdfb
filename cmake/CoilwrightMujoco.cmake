# Not by Debian's package of it, which names a folder of another one that it does not install.
find_path(MUJOCO_INCLUDE mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
mark_as_advanced(MUJOCO_INCLUDE MUJOCO_LIBRARY)

# coilwright_mujoco_program(<name> <source>...): a program of the tests that runs MuJoCo; none where that is not installed.
function(coilwright_mujoco_program name)
  if(NOT MUJOCO_INCLUDE OR NOT MUJOCO_LIBRARY)
    return()
  endif()
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_include_directories(${name} SYSTEM PRIVATE ${MUJOCO_INCLUDE})
  target_link_libraries(${name} PRIVATE ${MUJOCO_LIBRARY})
  target_compile_features(${name} PRIVATE cxx_std_20)
  coilwright_warnings(${name})
endfunction()
