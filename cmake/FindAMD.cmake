# Finds AMD of SuiteSparse, the library libamd alone, and defines SuiteSparse::AMD, the name SuiteSparse 7 gives it. For
# versions that ship no CMake package (before 7.4, Debian 12 among them). Sets AMD_FOUND, AMD_INCLUDE_DIR, AMD_LIBRARY,
# AMD_VERSION. Relocatable: installed beside the package config, it looks for AMD anew.
if(TARGET SuiteSparse::AMD)
  set(AMD_FOUND TRUE)
  return()
endif()

find_package(AMD CONFIG QUIET)
if(TARGET SuiteSparse::AMD)
  return()
endif()

find_path(AMD_INCLUDE_DIR amd.h PATH_SUFFIXES suitesparse)
find_library(AMD_LIBRARY amd)
mark_as_advanced(AMD_INCLUDE_DIR AMD_LIBRARY)

if(AMD_INCLUDE_DIR)
  file(STRINGS ${AMD_INCLUDE_DIR}/amd.h lines REGEX "#define AMD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]+")
  list(TRANSFORM lines REPLACE "[^0-9]+" "")
  list(JOIN lines "." AMD_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AMD REQUIRED_VARS AMD_LIBRARY AMD_INCLUDE_DIR VERSION_VAR AMD_VERSION)

if(AMD_FOUND)
  add_library(SuiteSparse::AMD UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::AMD PROPERTIES IMPORTED_LOCATION ${AMD_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${AMD_INCLUDE_DIR})
  # A static libamd does not bring what it stands on.
  if(AMD_LIBRARY MATCHES "\\${CMAKE_STATIC_LIBRARY_SUFFIX}$")
    find_library(AMD_suitesparseconfig_LIBRARY suitesparseconfig)
    mark_as_advanced(AMD_suitesparseconfig_LIBRARY)
    if(AMD_suitesparseconfig_LIBRARY)
      set_property(TARGET SuiteSparse::AMD PROPERTY INTERFACE_LINK_LIBRARIES ${AMD_suitesparseconfig_LIBRARY})
    endif()
  endif()
endif()
