# Warnings of our own targets: private options, so that nothing of them is exported.
#
# -Wdouble-promotion is about float to double; clang means double to long double by it too, which references in tests do on
# purpose. Kernels combine comparisons with `&`, because T may be a pack; with T = double clang would like `&&`.
function(isostretch_enable_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wimplicit-fallthrough
    $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-bitwise-instead-of-logical>
    $<$<BOOL:${ISOSTRETCH_WERROR}>:-Werror>)
endfunction()

# Sanitizers go to every target of the build: a mixture reports errors that are not there.
if(ISOSTRETCH_SANITIZE)
  add_compile_options(-fsanitize=${ISOSTRETCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ISOSTRETCH_SANITIZE})
endif()

# The same checks of memory as calls instead of inline code, which is slower to run: for the large templates of kernels and
# tests, of which a quarter to a half of the compile time is saved. gcc's spelling.
set(ISOSTRETCH_SANITIZE_BY_CALLS)
if(ISOSTRETCH_SANITIZE MATCHES "address" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(ISOSTRETCH_SANITIZE_BY_CALLS --param=asan-instrumentation-with-call-threshold=0)
endif()

# At -O1, and behind precompiled headers, gcc 12 takes the insides of Eigen and std::string for faults of their users.
set(ISOSTRETCH_NO_FALSE_ALARMS $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
