# Finds the C library of NLopt and defines NLopt::nlopt. Its own CMake package, where there is one, has the same target;
# but Debian splits it in two of one name, and the other has only the C++ interface. Sets NLopt_FOUND, NLOPT_INCLUDE_DIR,
# NLOPT_LIBRARY, and NLOPT_VERSION where the package tells. Relocatable: installed beside the package config, it looks for
# NLopt anew.
if(TARGET NLopt::nlopt)
  set(NLopt_FOUND TRUE)
  return()
endif()

find_package(NLopt CONFIG QUIET)
if(TARGET NLopt::nlopt)
  return()
endif()

find_path(NLOPT_INCLUDE_DIR nlopt.h)
find_library(NLOPT_LIBRARY nlopt)
mark_as_advanced(NLOPT_INCLUDE_DIR NLOPT_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NLopt REQUIRED_VARS NLOPT_LIBRARY NLOPT_INCLUDE_DIR)

if(NLopt_FOUND)
  add_library(NLopt::nlopt UNKNOWN IMPORTED)
  set_target_properties(NLopt::nlopt PROPERTIES IMPORTED_LOCATION ${NLOPT_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${NLOPT_INCLUDE_DIR})
endif()
