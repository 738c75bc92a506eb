# One language level, one set of warnings, one floating-point model for every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set_property(GLOBAL PROPERTY USE_FOLDERS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")

option(ALHAZEN_WERROR "treat warnings as errors" ON)
set(ALHAZEN_SANITIZE "" CACHE STRING "list for -fsanitize=, for instance address,undefined")

add_library(alhazen_options INTERFACE)
# docs/numerics.md: contraction would make a*b+c depend on the compiler; where a fused product is
# wanted the source says fma. -fno-math-errno lets sqrt be the one instruction; it changes no value.
target_compile_options(alhazen_options INTERFACE
  -ffp-contract=off -fno-math-errno
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
  -Woverloaded-virtual -Wnull-dereference -Wimplicit-fallthrough
  -Wno-missing-field-initializers)  # designated initialisers leave the rest to its defaults
if(ALHAZEN_WERROR)
  target_compile_options(alhazen_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_BUILD_TYPE STREQUAL "Release")
  # g++ 12 reports impossible null dereferences, overlaps and uninitialised strings through inlined std:: code
  # at -O3; the debug presets keep these warnings.
  target_compile_options(alhazen_options INTERFACE -Wno-null-dereference -Wno-maybe-uninitialized
                                                   -Wno-restrict)
endif()
if(ALHAZEN_SANITIZE)
  target_compile_options(alhazen_options INTERFACE
    -fsanitize=${ALHAZEN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
  target_link_options(alhazen_options INTERFACE -fsanitize=${ALHAZEN_SANITIZE})
endif()

# The __float128 oracle (docs/numerics.md) needs g++ and libquadmath.
set(has_quad OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(has_quad ON)
endif()
option(ALHAZEN_QUAD "the oracle in quad precision, which needs g++" ${has_quad})
if(ALHAZEN_QUAD AND NOT has_quad)
  message(FATAL_ERROR "ALHAZEN_QUAD: quad precision needs g++")
endif()
if(NOT ALHAZEN_QUAD)
  add_compile_definitions(ALHAZEN_WITHOUT_QUAD)
endif()
