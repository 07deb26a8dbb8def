# A script that IsostretchTests.cmake runs: asks PROGRAM for its cases, with SUITE those of a suite alone, and writes OUTPUT, a
# CTest file with an entry `PREFIX.<case>` of the given PROPERTIES for each.
cmake_minimum_required(VERSION 3.25)
set(filter "")
if(DEFINED SUITE)
  set(filter "--test-suite=${SUITE}")
endif()
execute_process(COMMAND ${PROGRAM} --list-test-cases --no-colors=true ${filter}
  OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\\[doctest\\][^\n]*\n|==+\n" "" listing "${listing}")

# Filters give stars and backslashes a meaning, CMake the others. A semicolon, which separates the items of lists, is
# another letter while there is a list.
if(listing MATCHES "[][$\"*?\\]")
  message(FATAL_ERROR "${PROGRAM}: the name of a case has a '${CMAKE_MATCH_0}' in it")
endif()
string(ASCII 31 semicolon)
string(REPLACE ";" ${semicolon} listing "${listing}")
string(REGEX REPLACE "\n+" ";" cases "${listing}")

set(names "")
set(text "")
foreach(case IN LISTS cases)
  if(case STREQUAL "")
    continue()
  endif()
  string(TOLOWER "${case}" name)  # as filters see it
  if(name IN_LIST names)
    message(FATAL_ERROR "${PROGRAM}: two cases are named '${case}'")
  endif()
  list(APPEND names "${name}")
  string(REPLACE ${semicolon} ";" case "${case}")
  string(REPLACE "," "\\," filter "${case}")
  string(APPEND text "add_test([==[${PREFIX}.${case}]==] [==[${PROGRAM}]==] [==[--test-case=${filter}]==])\n"
    "set_tests_properties([==[${PREFIX}.${case}]==] PROPERTIES")
  foreach(word IN LISTS PROPERTIES)
    string(APPEND text " [==[${word}]==]")
  endforeach()
  string(APPEND text ")\n")
endforeach()
if(names STREQUAL "" AND NOT DEFINED SUITE)
  message(FATAL_ERROR "${PROGRAM} has no test cases")
endif()
file(WRITE ${OUTPUT} "${text}")
