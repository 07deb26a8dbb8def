# Kernel files are compiled once per instruction-set level and chosen at load (core/isa.hpp).
#
# The flags stay private to the generated files, so no -march reaches a user's code. A kernel file may use only
# templates that live in the inline namespace ISOSTRETCH_ISA (core/isa_level.hpp): everything else with external linkage,
# Eigen and most of the standard library included, could be kept by the linker in its AVX-512 copy for everybody.
# tests/structure/check_kernel_symbols.py proves it on the object files.
include(CheckCXXCompilerFlag)

set(ISOSTRETCH_ISA_LEVELS base)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  check_cxx_compiler_flag(-march=x86-64-v4 ISOSTRETCH_COMPILER_KNOWS_LEVELS)
  if(ISOSTRETCH_COMPILER_KNOWS_LEVELS)
    list(APPEND ISOSTRETCH_ISA_LEVELS v2 v3 v4)
  endif()
endif()

# Optimised also in debug builds (the kernels are templates that cost a hundredfold otherwise), but not under
# sanitizers. Infinities are values here (outside the domain of an energy), so no -ffinite-math-only.
set(_isostretch_kernel_flags -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffp-contract=fast)
if(NOT ISOSTRETCH_SANITIZE)
  list(APPEND _isostretch_kernel_flags -O3)
endif()

# gcc 12 warns about the "undefined" operands inside its own AVX-512 header.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND _isostretch_kernel_flags -Wno-maybe-uninitialized -Wno-uninitialized)
endif()

# Compiles each of the files given at every level. Without files it only tells the library which levels there are.
function(isostretch_add_kernels target)
  if(v2 IN_LIST ISOSTRETCH_ISA_LEVELS)
    target_compile_definitions(${target} PRIVATE ISOSTRETCH_HAS_ISA_LEVELS=1)
  endif()
  foreach(file IN LISTS ARGN)
    get_filename_component(stem ${file} NAME_WE)
    foreach(level IN LISTS ISOSTRETCH_ISA_LEVELS)
      set(unit ${CMAKE_CURRENT_BINARY_DIR}/kernels/${stem}.${level}.cpp)
      # A relative path: for a compiler cache the unit is then the same in every clone.
      file(RELATIVE_PATH source ${CMAKE_CURRENT_BINARY_DIR}/kernels ${CMAKE_CURRENT_SOURCE_DIR}/${file})
      file(CONFIGURE OUTPUT ${unit} CONTENT "#include \"${source}\"\n" @ONLY)
      set(flags ${_isostretch_kernel_flags} ${ISOSTRETCH_SANITIZE_BY_CALLS})
      if(NOT level STREQUAL base)
        list(APPEND flags -march=x86-64-${level})
      endif()
      # The same templates with sanitizers at two levels, scalar and packs of two: at all four they compile for minutes.
      if(ISOSTRETCH_SANITIZE AND level MATCHES "v3|v4")
        list(APPEND flags -fno-sanitize=all)
      endif()
      set_source_files_properties(${unit} PROPERTIES COMPILE_OPTIONS "${flags}"
        OBJECT_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file}
        SKIP_PRECOMPILE_HEADERS ON)  # other flags, and nothing but what they include themselves
      target_sources(${target} PRIVATE ${unit})
    endforeach()
  endforeach()
endfunction()
