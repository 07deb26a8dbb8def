# Headers of others that most files include, read once for the whole build instead of once per file. An option for builds
# that are made for their tests: with it a file that forgets an include compiles all the same, so ordinary builds go without.

# What many files take. Not <nlohmann/json.hpp>: a file without it would take a second more for nothing. And <filesystem>,
# which few files need, declares std::quoted, and that hides functions of this name where an argument is a std::string.
set(_isostretch_precompiled <Eigen/Dense> <Eigen/SparseCore> <algorithm> <array> <charconv> <cmath> <fstream> <functional>
  <limits> <map> <memory> <numeric> <optional> <random> <set> <sstream> <string> <string_view> <utility> <vector>)

# For every target of this folder and those below; call it when all are there.
function(isostretch_precompile_headers)
  if(NOT ISOSTRETCH_PRECOMPILED_HEADERS)
    return()
  endif()
  get_property(folders DIRECTORY ${ARGN} PROPERTY SUBDIRECTORIES)
  foreach(folder IN LISTS folders)
    isostretch_precompile_headers(${folder})
  endforeach()
  get_property(targets DIRECTORY ${ARGN} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC_LIBRARY|SHARED_LIBRARY|EXECUTABLE)$" AND NOT target STREQUAL isostretch_test_support)
      _isostretch_precompile_headers_of(${target})
    endif()
  endforeach()
endfunction()

# Compilers take a precompiled header only with the options that it was made with: one for each combination in use. Programs
# share theirs with libraries, by -fPIC, and have OpenMP in any case, which changes nothing for sources without directives.
function(_isostretch_precompile_headers_of target)
  get_target_property(position_independent ${target} POSITION_INDEPENDENT_CODE)
  get_target_property(options ${target} COMPILE_OPTIONS)
  get_target_property(links ${target} LINK_LIBRARIES)
  find_package(OpenMP QUIET COMPONENTS CXX)
  get_target_property(type ${target} TYPE)
  set(carrier isostretch_precompiled)
  if(options MATCHES "-O[01]")
    string(APPEND carrier _quick)
    target_compile_options(${target} PRIVATE -fPIC)
  elseif(NOT position_independent)
    return()  # a benchmark or an example
  endif()
  if(links MATCHES "OpenMP::OpenMP_CXX" OR (type STREQUAL "EXECUTABLE" AND OpenMP_CXX_FOUND))
    string(APPEND carrier _openmp)
    target_compile_options(${target} PRIVATE ${OpenMP_CXX_FLAGS})
    target_link_options(${target} PRIVATE ${OpenMP_CXX_FLAGS})
  endif()

  if(NOT TARGET ${carrier})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "" @ONLY)
    add_library(${carrier} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/precompiled.cpp)
    find_package(Eigen3 3.4 REQUIRED NO_MODULE)
    target_link_libraries(${carrier} PRIVATE Eigen3::Eigen)
    target_compile_features(${carrier} PRIVATE cxx_std_20)
    target_compile_options(${carrier} PRIVATE "${options}")
    if(carrier MATCHES "_openmp")
      target_compile_options(${carrier} PRIVATE ${OpenMP_CXX_FLAGS})
    endif()
    set_target_properties(${carrier} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_precompile_headers(${carrier} PRIVATE ${_isostretch_precompiled})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${carrier})
  # Preprocessed sources that name a precompiled header are what ccache needs to take files that use one from its cache.
  target_compile_options(${target} PRIVATE ${ISOSTRETCH_NO_FALSE_ALARMS} $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()
