# The API reference: the target `reference` makes pages of what the /// comments of public headers say, with Doxygen, in
# <build>/reference/html. The test docs.reference makes them too and fails on warnings.
find_program(ISOSTRETCH_DOXYGEN doxygen DOC "Doxygen, for the API reference")

# Writes the Doxyfile that target and test share.
function(_isostretch_configure_doxyfile)
  set(folder ${PROJECT_BINARY_DIR}/reference)
  get_property(components GLOBAL PROPERTY ISOSTRETCH_COMPONENTS)
  set(includes "")
  foreach(component IN LISTS components)
    string(APPEND includes " \"${PROJECT_SOURCE_DIR}/libs/${component}/include\"")
  endforeach()
  set(generated "\"${PROJECT_BINARY_DIR}/libs/core/include\"")
  set(ISOSTRETCH_REFERENCE_DIR ${folder})
  set(ISOSTRETCH_REFERENCE_STRIP "${includes} ${generated}")
  set(ISOSTRETCH_REFERENCE_INPUT "${includes} ${generated} \"${PROJECT_SOURCE_DIR}/docs/reference/pages.dox\"")
  configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile.in ${folder}/Doxyfile @ONLY)
endfunction()

function(isostretch_add_reference)
  _isostretch_configure_doxyfile()
  if(NOT ISOSTRETCH_DOXYGEN)
    set_property(GLOBAL APPEND PROPERTY ISOSTRETCH_FEATURES "API reference: off (no doxygen; tools/setup installs it)")
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY ISOSTRETCH_FEATURES "API reference: target reference")
  add_custom_target(reference
    COMMAND ${ISOSTRETCH_DOXYGEN} ${PROJECT_BINARY_DIR}/reference/Doxyfile
    COMMAND ${CMAKE_COMMAND} -E echo "${PROJECT_BINARY_DIR}/reference/html/index.html"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Doxygen: what public headers say" VERBATIM)
endfunction()
