# The target `coverage`: which lines of libraries and apps the tests ran that were run since the counters were last removed, as
# pages in <build>/html and a table on the terminal. Run tests first: ctest --preset coverage, or a part of them.
find_program(ISOSTRETCH_GCOVR gcovr)
if(NOT ISOSTRETCH_GCOVR)
  message(FATAL_ERROR "coverage needs gcovr (tools/setup --all)")
endif()
add_custom_target(coverage
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/html
  COMMAND ${ISOSTRETCH_GCOVR} --root ${PROJECT_SOURCE_DIR} --filter "libs/.*/(src|include)/" --filter "apps/"
    --exclude-throw-branches --gcov-ignore-parse-errors --print-summary --html-details ${PROJECT_BINARY_DIR}/html/index.html
    ${PROJECT_BINARY_DIR}
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  VERBATIM USES_TERMINAL)
