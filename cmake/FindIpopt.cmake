# Finds Ipopt, which comes with a pkg-config file but no CMake package, and defines Ipopt::Ipopt. Sets Ipopt_FOUND,
# IPOPT_INCLUDE_DIR, IPOPT_LIBRARY, IPOPT_VERSION. Relocatable: installed beside the package config, it looks for Ipopt
# anew.
if(TARGET Ipopt::Ipopt)
  set(Ipopt_FOUND TRUE)
  return()
endif()

# coin-or since 3.13. A shared library brings what it stands on; a static one does not.
find_path(IPOPT_INCLUDE_DIR IpIpoptApplication.hpp PATH_SUFFIXES coin-or coin)
find_library(IPOPT_LIBRARY ipopt)
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)

if(IPOPT_INCLUDE_DIR)
  file(STRINGS ${IPOPT_INCLUDE_DIR}/IpoptConfig.h lines REGEX "#define IPOPT_VERSION +\"[0-9.]+\"")
  if(lines MATCHES "\"([0-9.]+)\"")
    set(IPOPT_VERSION ${CMAKE_MATCH_1})
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR VERSION_VAR IPOPT_VERSION)

if(Ipopt_FOUND)
  add_library(Ipopt::Ipopt UNKNOWN IMPORTED)
  # Headers of 3.11 end the compilation unless they are told that there is <cstddef>.
  set_target_properties(Ipopt::Ipopt PROPERTIES IMPORTED_LOCATION ${IPOPT_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${IPOPT_INCLUDE_DIR} INTERFACE_COMPILE_DEFINITIONS HAVE_CSTDDEF)
endif()
