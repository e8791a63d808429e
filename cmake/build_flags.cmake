# Flags of every target of this project.

add_library(rad_build_flags INTERFACE)
target_compile_features(rad_build_flags INTERFACE cxx_std_20)
target_compile_options(rad_build_flags INTERFACE
  -Wall -Wextra -Wno-missing-field-initializers -Wno-restrict -Wshadow -Wnon-virtual-dtor -Wcast-align -Wunused -Woverloaded-virtual
  # The same bits on every CPU of a family: no fused multiply-add that the source does not ask for.
  -ffp-contract=off)
if(RAD_WARNINGS_AS_ERRORS)
  target_compile_options(rad_build_flags INTERFACE -Werror)
endif()

set(RAD_SANITIZE "" CACHE STRING "Sanitizers for every target: address,undefined | thread")
if(RAD_SANITIZE)
  add_compile_options(-fsanitize=${RAD_SANITIZE} -fno-omit-frame-pointer)
  if(RAD_SANITIZE MATCHES undefined)
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
  add_link_options(-fsanitize=${RAD_SANITIZE})
endif()
