# coilwright_commit(<target>): gives <target> a source, made from src/results/commit.cpp.in, that says from which commit it was
# built. The repository is asked at every build, and the file is only touched when the answer changes: then this one
# source is compiled and the program linked, and nothing else.
set(COILWRIGHT_COMMIT "" CACHE STRING "Commit of these sources, for builds outside of their git repository")
mark_as_advanced(COILWRIGHT_COMMIT)

function(coilwright_commit target)
  find_package(Git QUIET)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/commit.cpp)
  add_custom_target(${target}_commit
    COMMAND ${CMAKE_COMMAND} -Dgit=${GIT_EXECUTABLE} -Dsources=${PROJECT_SOURCE_DIR} -Dstated=${COILWRIGHT_COMMIT}
      -Dtemplate=${PROJECT_SOURCE_DIR}/src/results/commit.cpp.in -Doutput=${source}
      -P ${PROJECT_SOURCE_DIR}/cmake/WriteCommit.cmake
    BYPRODUCTS ${source}
    COMMENT ""
    VERBATIM)
  set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE ${source})
  add_dependencies(${target} ${target}_commit)
endfunction()
