# Warnings of our own targets: private options, so that nothing of them is exported.
function(isostretch_enable_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wdouble-promotion
    -Wimplicit-fallthrough
    $<$<BOOL:${ISOSTRETCH_WERROR}>:-Werror>)
endfunction()

# Sanitizers go to every target of the build: a mixture reports errors that are not there.
if(ISOSTRETCH_SANITIZE)
  add_compile_options(-fsanitize=${ISOSTRETCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ISOSTRETCH_SANITIZE})
endif()
