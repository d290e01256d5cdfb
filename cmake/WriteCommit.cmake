# cmake -Dgit=... -Dsources=... -Dstated=... -Dtemplate=... -Doutput=... -P WriteCommit.cmake
#
# Writes the commit of `sources` into the template. It stays empty, which the program calls unknown, where there is no
# git, or where the repository around the sources is another one: sources unpacked in somebody else's.
set(commit "${stated}")
set(changed false)
if(NOT commit AND git)
  execute_process(COMMAND ${git} -C ${sources} rev-parse --show-toplevel HEAD
    OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX MATCH "^([^\n]+)\n([0-9a-f]+)$" both "${answer}")
  set(root "${CMAKE_MATCH_1}")
  set(head "${CMAKE_MATCH_2}")
  file(REAL_PATH "${sources}" sources)
  if(both AND NOT failed)
    file(REAL_PATH "${root}" root)
    if(root STREQUAL sources)
      set(commit ${head})
      # Only what is built counts: a changed page of the documents makes no other program.
      execute_process(COMMAND ${git} -C ${sources} --no-optional-locks diff --quiet HEAD -- src include cmake configs
        RESULT_VARIABLE differs ERROR_QUIET)
      if(NOT differs EQUAL 0)
        set(changed true)
      endif()
    endif()
  endif()
endif()
# All programs of one build have these: their own files differ.
set(digest "")
if(changed OR NOT commit)
  file(GLOB_RECURSE files RELATIVE ${sources} ${sources}/src/* ${sources}/include/* ${sources}/cmake/* ${sources}/configs/*)
  list(SORT files)
  set(all "")
  foreach(file IN LISTS files)
    file(SHA256 ${sources}/${file} one)
    string(APPEND all "${one} ${file}\n")
  endforeach()
  string(SHA256 digest "${all}")
endif()
configure_file(${template} ${output} @ONLY)
