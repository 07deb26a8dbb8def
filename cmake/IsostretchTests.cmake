# Registers doctest programs with CTest. Which cases a program has is asked of the program itself, after it is linked:
# IsostretchDiscoverTests.cmake writes the entries.
#
# isostretch_register_tests(isostretch_apps_tests
#   NAME apps      name of the entry, and prefix of the entries of single cases
#   LABEL apps     CTest's label of all of them; NAME where it is left out
#   EACH_CASE      an entry `NAME.<case>` for every case, in place of one for all of them, besides those for cases that cannot
#                  run everywhere: for cases that take seconds
#   PLAIN_ENVIRONMENT)  for programs that run apps, which choose for themselves how threads wait
function(isostretch_register_tests target)
  cmake_parse_arguments(A "EACH_CASE;PLAIN_ENVIRONMENT" "NAME;LABEL" "" ${ARGN})
  if(NOT A_LABEL)
    set(A_LABEL ${A_NAME})
  endif()
  # A program into which no test was linked must not pass, nor an entry whose case is not there any more. A case that cannot
  # run here is skipped (tests/support/conditional.hpp).
  set(properties LABELS ${A_LABEL} FAIL_REGULAR_EXPRESSION "test cases: +0 [|]" SKIP_RETURN_CODE 77)
  if(NOT A_PLAIN_ENVIRONMENT)
    # OpenMP threads that spin while they wait starve whatever runs beside them.
    list(APPEND properties ENVIRONMENT OMP_WAIT_POLICY=passive)
  endif()
  set(suite "")
  if(NOT A_EACH_CASE)
    add_test(NAME ${A_NAME} COMMAND ${target} --test-suite-exclude=conditional)
    set_tests_properties(${A_NAME} PROPERTIES ${properties})
    set(suite -D SUITE=conditional)
  endif()

  set(entries ${CMAKE_CURRENT_BINARY_DIR}/${target}_cases.cmake)
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
  set(script ${PROJECT_SOURCE_DIR}/cmake/IsostretchDiscoverTests.cmake)
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${entries}
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D PREFIX=${A_NAME} ${suite} -D "PROPERTIES=${properties}"
      -D OUTPUT=${entries} -P ${script}
    VERBATIM)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
  # A program that is not built is a test that fails.
  file(CONFIGURE OUTPUT ${include} @ONLY CONTENT
[[if(EXISTS "@entries@")
  include("@entries@")
else()
  add_test("@A_NAME@.not_built" "@target@ is not built")
  set_tests_properties("@A_NAME@.not_built" PROPERTIES LABELS "@A_LABEL@")
endif()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
