# cmake -DDOXYGEN=PROGRAM -DFOLDER=FOLDER_OF_DOXYFILE -P RunDoxygen.cmake
#
# Runs Doxygen and fails on any of its warnings but those about members of a documented class that say all by their name
# and type: a data member of a struct, an accessor `name() const noexcept`, a copy, a move or a comparison. Everything
# else in a public header must have a comment of its own.
execute_process(COMMAND "${DOXYGEN}" "${FOLDER}/Doxyfile" RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "doxygen ended with ${result}")
endif()
file(STRINGS "${FOLDER}/warnings.txt" lines)
set(faults)
foreach(line IN LISTS lines)
  if(NOT line MATCHES "Member .* \\(variable\\) of struct .* is not documented"
     AND NOT line MATCHES "Member [A-Za-z_]+\\(\\) const noexcept \\(function\\) of .* is not documented"
     AND NOT line MATCHES "Member [A-Za-z]+\\((const )?[A-Za-z]+ &&?\\)( noexcept|=default) \\(function\\) of .* is not documented"
     AND NOT line MATCHES "Member operator==?\\(.*\\)( noexcept|=default) \\((function|friend)\\) of .* is not documented")
    string(APPEND faults "${line}\n")
  endif()
endforeach()
if(faults)
  message(FATAL_ERROR "public headers with faults in their comments:\n${faults}")
endif()
