# One call defines a library folder: target, headers, kernels, install rules, package files, tests and benchmarks.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(IsostretchWarnings)
include(IsostretchKernels)
include(IsostretchTests)

set(ISOSTRETCH_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/isostretch)
# Apps of a shared build find the libraries wherever both are moved together; libraries set their own below.
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/isostretch")
# Solvers that are loaded when they are asked for.
set(ISOSTRETCH_MODULE_DIR ${PROJECT_BINARY_DIR}/modules)
set(CMAKE_BUILD_RPATH ${ISOSTRETCH_MODULE_DIR})
define_property(GLOBAL PROPERTY ISOSTRETCH_COMPONENTS BRIEF_DOCS "components in dependency order")
define_property(GLOBAL PROPERTY ISOSTRETCH_FEATURES BRIEF_DOCS "lines of the configure summary")

# isostretch_add_library(newton
#   SOURCES src/a.cpp ...            compiled plainly; leave out for a header-only library
#   SEPARATE src/c.cpp ...           those of them, or tests, that a unity build compiles by themselves: their names clash
#   KERNELS src/k.cpp ...            compiled once per instruction-set level (IsostretchKernels.cmake)
#   COMPONENTS assembly ...          our own libraries, public
#   PACKAGES "Eigen3 3.4 NO_MODULE"  find_package calls that a consumer of this component needs too
#   LINK Eigen3::Eigen ...           public third-party targets
#   LINK_PRIVATE OpenMP::...         third-party targets that no public header shows
#   TESTS tests/t.cpp ...            one doctest program, labelled with the library's name
#   TEST_COMPONENTS testing ...      further libraries that only the tests link
#   TEST_PACKAGES "nlohmann_json"    find_package calls of the tests alone
#   TEST_LINK nlohmann_json::...     third-party targets that only the tests link
#   BENCHES bench/b.cpp ...)         one Google Benchmark program
function(isostretch_add_library name)
  cmake_parse_arguments(A "" ""
    "SOURCES;SEPARATE;KERNELS;COMPONENTS;PACKAGES;LINK;LINK_PRIVATE;TESTS;TEST_COMPONENTS;TEST_PACKAGES;TEST_LINK;BENCHES" ${ARGN})
  if(A_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isostretch_add_library(${name}): unknown arguments ${A_UNPARSED_ARGUMENTS}")
  endif()
  set(target isostretch_${name})
  if(A_SOURCES OR A_KERNELS)
    set(scope PUBLIC)
    add_library(${target} ${A_SOURCES})
    isostretch_enable_warnings(${target})
    isostretch_unite_sources(${target} SEPARATE ${A_SEPARATE})
    isostretch_add_kernels(${target} ${A_KERNELS})
    # A shared library calls its own copies of Eigen's inline functions, not those of a program that may have been
    # compiled with another -march and allocates differently.
    if(BUILD_SHARED_LIBS AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
      target_link_options(${target} PRIVATE LINKER:-Bsymbolic-functions)
    endif()
    if(NOT TARGET isostretch_libraries)
      add_custom_target(isostretch_libraries)  # all of them, without tests and apps
    endif()
    add_dependencies(isostretch_libraries ${target})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(isostretch::${name} ALIAS ${target})

  _isostretch_find_packages("${A_PACKAGES}" "${A_LINK};${A_LINK_PRIVATE}")
  list(TRANSFORM A_COMPONENTS PREPEND "isostretch::" OUTPUT_VARIABLE components)
  target_link_libraries(${target} ${scope} ${components} ${A_LINK})
  if(A_LINK_PRIVATE)
    target_link_libraries(${target} PRIVATE ${A_LINK_PRIVATE})
  endif()
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    INSTALL_RPATH "$ORIGIN"  # shared builds: the libraries find each other wherever they are installed
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set_property(GLOBAL APPEND PROPERTY ISOSTRETCH_COMPONENTS ${name})
  _isostretch_install_component(${name} "${A_COMPONENTS}" "${A_PACKAGES}")

  if(ISOSTRETCH_BUILD_TESTS AND A_TESTS)
    foreach(package IN LISTS A_TEST_PACKAGES)
      separate_arguments(words UNIX_COMMAND "${package}")
      find_package(${words} REQUIRED)
    endforeach()
    list(TRANSFORM A_TEST_COMPONENTS PREPEND "isostretch_" OUTPUT_VARIABLE test_components)
    add_executable(${target}_tests ${A_TESTS})
    target_link_libraries(${target}_tests PRIVATE ${target} ${test_components} ${A_TEST_LINK}
      isostretch_test_support)
    isostretch_enable_warnings(${target}_tests)
    isostretch_compile_quickly(${target}_tests)
    isostretch_unite_sources(${target}_tests)
    isostretch_register_tests(${target}_tests NAME ${name})
  endif()
  if(ISOSTRETCH_BUILD_BENCHMARKS AND A_BENCHES)
    find_package(benchmark REQUIRED)
    add_executable(${target}_bench ${A_BENCHES})
    target_link_libraries(${target}_bench PRIVATE ${target} benchmark::benchmark)
    isostretch_enable_warnings(${target}_bench)
  endif()
endfunction()

# Sources of a target are compiled a dozen at a time where ISOSTRETCH_UNITY_BUILD asks for it.
function(isostretch_unite_sources target)
  cmake_parse_arguments(A "" "" "SEPARATE" ${ARGN})
  if(ISOSTRETCH_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    set_source_files_properties(${A_SEPARATE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# Sets openmp_packages and openmp_link of a library that uses threads where there is OpenMP and does without elsewhere.
macro(isostretch_find_optional_openmp)
  find_package(OpenMP QUIET COMPONENTS CXX)
  set(openmp_packages)
  set(openmp_link)
  if(OpenMP_CXX_FOUND)
    set(openmp_packages "OpenMP COMPONENTS CXX")
    set(openmp_link OpenMP::OpenMP_CXX)
  endif()
endmacro()

# For tests, apps and libraries that put texts together: what runs once is not worth minutes of optimising, least of all
# instrumented templates.
function(isostretch_compile_quickly target)
  if(ISOSTRETCH_SANITIZE)
    target_compile_options(${target} PRIVATE -O0 ${ISOSTRETCH_SANITIZE_BY_CALLS})
  elseif(CMAKE_BUILD_TYPE STREQUAL Release)
    target_compile_options(${target} PRIVATE -O1 ${ISOSTRETCH_NO_FALSE_ALARMS})
  endif()
endfunction()

# A macro, for the callers' sake: what is found is seen by the whole library folder. A parent project that has made the
# targets already (FetchContent) wins.
macro(_isostretch_find_packages packages targets)
  set(_isostretch_missing FALSE)
  foreach(_isostretch_target ${targets})
    if(_isostretch_target MATCHES "::" AND NOT TARGET ${_isostretch_target})
      set(_isostretch_missing TRUE)
    endif()
  endforeach()
  if(_isostretch_missing)
    foreach(_isostretch_package ${packages})
      separate_arguments(_isostretch_words UNIX_COMMAND "${_isostretch_package}")
      find_package(${_isostretch_words} REQUIRED)
    endforeach()
  endif()
endmacro()

# Install rules of one component: its own EXPORT set, and a small file that finds just what it needs.
function(_isostretch_install_component name components packages)
  if(NOT ISOSTRETCH_INSTALL)
    return()
  endif()
  set(target isostretch_${name})
  install(TARGETS ${target} EXPORT isostretch-${name}
    RUNTIME COMPONENT ${name} LIBRARY COMPONENT ${name} ARCHIVE COMPONENT ${name})
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${name} FILES_MATCHING PATTERN "*.hpp")
  install(EXPORT isostretch-${name} NAMESPACE isostretch:: FILE isostretch-${name}-targets.cmake
    DESTINATION ${ISOSTRETCH_PACKAGE_DIR} COMPONENT ${name})
  export(EXPORT isostretch-${name} NAMESPACE isostretch::
    FILE ${PROJECT_BINARY_DIR}/isostretch-${name}-targets.cmake)
  set(text "")
  foreach(component IN LISTS components)
    string(APPEND text "_isostretch_load(${component} ${name})\n"
      "if(NOT isostretch_FOUND)\n  return()\nendif()\n")
  endforeach()
  foreach(package IN LISTS packages)
    string(APPEND text "find_dependency(${package})\n")
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/isostretch-${name}-deps.cmake CONTENT "${text}" @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/isostretch-${name}-deps.cmake
    DESTINATION ${ISOSTRETCH_PACKAGE_DIR} COMPONENT ${name})
endfunction()

function(isostretch_finalize_package)
  if(NOT ISOSTRETCH_INSTALL)
    return()
  endif()
  get_property(ISOSTRETCH_ALL_COMPONENTS GLOBAL PROPERTY ISOSTRETCH_COMPONENTS)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/isostretchConfig.cmake.in
    ${PROJECT_BINARY_DIR}/isostretchConfig.cmake INSTALL_DESTINATION ${ISOSTRETCH_PACKAGE_DIR}
    NO_CHECK_REQUIRED_COMPONENTS_MACRO NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/isostretchConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  # Part of every component's installation: whichever is installed alone must be findable.
  foreach(component IN LISTS ISOSTRETCH_ALL_COMPONENTS)
    install(FILES ${PROJECT_BINARY_DIR}/isostretchConfig.cmake ${PROJECT_BINARY_DIR}/isostretchConfigVersion.cmake
      DESTINATION ${ISOSTRETCH_PACKAGE_DIR} COMPONENT ${component})
  endforeach()
  # Find modules for dependencies that ship no CMake package of their own. Nobody links what is in modules of ours.
  file(GLOB find_modules ${PROJECT_SOURCE_DIR}/cmake/Find*.cmake)
  list(FILTER find_modules EXCLUDE REGEX "Ipopt|NLopt")
  install(FILES ${find_modules} DESTINATION ${ISOSTRETCH_PACKAGE_DIR} COMPONENT sparse)
  file(COPY ${find_modules} DESTINATION ${PROJECT_BINARY_DIR})
endfunction()

function(isostretch_note_feature text)
  set_property(GLOBAL APPEND PROPERTY ISOSTRETCH_FEATURES "${text}")
endfunction()

function(isostretch_print_summary)
  get_property(components GLOBAL PROPERTY ISOSTRETCH_COMPONENTS)
  get_property(features GLOBAL PROPERTY ISOSTRETCH_FEATURES)
  list(JOIN components ", " components)
  message(STATUS "isostretch ${PROJECT_VERSION} (${CMAKE_BUILD_TYPE}): ${components}")
  foreach(feature IN LISTS features)
    message(STATUS "  ${feature}")
  endforeach()
endfunction()
