# Finds CHOLMOD of SuiteSparse and defines SuiteSparse::CHOLMOD, the name SuiteSparse 7 gives it. For versions that ship
# no CMake package (before 7.4, Debian 12 among them). Sets CHOLMOD_FOUND, CHOLMOD_INCLUDE_DIR, CHOLMOD_LIBRARY,
# CHOLMOD_VERSION. Relocatable: installed beside the package config, it looks for CHOLMOD anew.
if(TARGET SuiteSparse::CHOLMOD)
  set(CHOLMOD_FOUND TRUE)
  return()
endif()

find_package(CHOLMOD CONFIG QUIET)
if(TARGET SuiteSparse::CHOLMOD)
  return()
endif()

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

if(CHOLMOD_INCLUDE_DIR)
  # cholmod_core.h up to SuiteSparse 6, cholmod.h since.
  foreach(header cholmod_core.h cholmod.h)
    if(NOT CHOLMOD_VERSION AND EXISTS ${CHOLMOD_INCLUDE_DIR}/${header})
      file(STRINGS ${CHOLMOD_INCLUDE_DIR}/${header} lines REGEX "#define CHOLMOD_(MAIN|SUB)_VERSION +[0-9]+")
      list(JOIN lines " " text)
      if(text MATCHES "MAIN_VERSION +([0-9]+)")
        set(CHOLMOD_VERSION ${CMAKE_MATCH_1})
      endif()
      if(text MATCHES "SUB_VERSION +([0-9]+)")
        string(APPEND CHOLMOD_VERSION .${CMAKE_MATCH_1})
      endif()
    endif()
  endforeach()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR
  VERSION_VAR CHOLMOD_VERSION)

if(CHOLMOD_FOUND)
  add_library(SuiteSparse::CHOLMOD UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::CHOLMOD PROPERTIES IMPORTED_LOCATION ${CHOLMOD_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${CHOLMOD_INCLUDE_DIR})
  # A static CHOLMOD does not bring what it stands on.
  if(CHOLMOD_LIBRARY MATCHES "\\${CMAKE_STATIC_LIBRARY_SUFFIX}$")
    find_package(LAPACK QUIET)
    foreach(part camd ccolamd colamd amd metis suitesparseconfig)
      find_library(CHOLMOD_${part}_LIBRARY ${part})
      mark_as_advanced(CHOLMOD_${part}_LIBRARY)
      if(CHOLMOD_${part}_LIBRARY)
        set_property(TARGET SuiteSparse::CHOLMOD APPEND PROPERTY
          INTERFACE_LINK_LIBRARIES ${CHOLMOD_${part}_LIBRARY})
      endif()
    endforeach()
    set_property(TARGET SuiteSparse::CHOLMOD APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${LAPACK_LIBRARIES})
  endif()
endif()
