# coilwright_pack(<target> <function> <folder> <file>...): gives <target>, a library of the room in whose folder this is
# said, the source of a function of the packed_files.hpp of this folder that returns these files of <folder>. It is made
# anew when one of them changes.
function(coilwright_pack target function folder)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/src OUTPUT_VARIABLE place)
  string(REGEX REPLACE "/.*" "" room ${place})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/packed_${function}.cpp)
  set(paths ${ARGN})
  list(TRANSFORM paths PREPEND ${folder}/)
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -Droom=${room} -Dplace=${place} -Dfunction=${function} -Dfolder=${folder} -Dfiles=${files} -Doutput=${source}
      -P ${PROJECT_SOURCE_DIR}/cmake/PackFiles.cmake
    DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/PackFiles.cmake
    VERBATIM)
  set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS $<$<CXX_COMPILER_ID:Clang>:-Wno-overlength-strings>)
  target_sources(${target} PRIVATE ${source})
endfunction()
