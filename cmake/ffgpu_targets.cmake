# How ffgpu's targets are made: the warnings, the arithmetic, and one library a folder.

add_library(ffgpu_options INTERFACE)
target_compile_options(ffgpu_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  -ffp-contract=off) # gcc and clang both fuse a multiply and an add otherwise: other bits.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12 inside its own and other libraries' inlined templates.
  target_compile_options(ffgpu_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow)
endif()
# Vectors of SVE have no size, and cannot be members, as those of Highway's forms here are. Its
# target NEON has the instructions of cryptography in it, and so has all that is inlined into it.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  target_compile_options(ffgpu_options INTERFACE -march=armv8-a+crypto)
  target_compile_definitions(ffgpu_options INTERFACE HWY_COMPILE_ONLY_STATIC)
endif()
target_include_directories(ffgpu_options INTERFACE ${PROJECT_SOURCE_DIR})
if(FFGPU_CHECK_RANGES)
  target_compile_definitions(ffgpu_options INTERFACE FFGPU_CHECK_RANGES)
endif()

# A finding ends the program. SystemC's library has no type information of its own classes to check
# (vptr).
if(FFGPU_SANITIZE)
  target_compile_options(ffgpu_options INTERFACE
    -fsanitize=${FFGPU_SANITIZE} -fno-sanitize-recover=all -fno-sanitize=vptr -fno-omit-frame-pointer)
  target_link_options(ffgpu_options INTERFACE -fsanitize=${FFGPU_SANITIZE} -fno-sanitize=vptr)
endif()

# Calls between files that lie apart, but are taken so often that the linker is to inline them.
# ffgpu_inlined_by_linker(files...): the files, of the current folder; ffgpu_links_inlined(target
# scope): the linker of all that they go into is told to use all processors for it.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT FFGPU_SANITIZE)
  set(FFGPU_OPTIMIZES_AT_LINK ON)
endif()
function(ffgpu_inlined_by_linker)
  if(FFGPU_OPTIMIZES_AT_LINK)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS "$<$<CONFIG:Release>:-flto;-ffat-lto-objects>")
  endif()
endfunction()
function(ffgpu_links_inlined target scope)
  if(FFGPU_OPTIMIZES_AT_LINK)
    target_link_options(${target} ${scope} $<$<CONFIG:Release>:-flto=auto>)
  endif()
endfunction()

# ffgpu_library(name folder [EXCLUDE subfolder ...] [LINKS ...]): a static library of all .cpp files
# of the folder, but for those of the subfolders.
function(ffgpu_library name folder)
  cmake_parse_arguments(arg "" "" "EXCLUDE;LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  foreach(excluded ${arg_EXCLUDE})
    list(FILTER sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${folder}/${excluded}/")
  endforeach()
  # Instrumented vectors compile for minutes a file; the scalar bodies give the same bits.
  if(FFGPU_FUZZ)
    set(vectors ${sources})
    list(FILTER vectors INCLUDE REGEX "_simd[.]cpp$")
    set_source_files_properties(${vectors} PROPERTIES COMPILE_OPTIONS
      "-fno-sanitize=undefined;-fno-sanitize=fuzzer-no-link")
    # The largest of them for ten minutes, with AddressSanitizer.
    list(FILTER vectors INCLUDE REGEX "/filter_simd[.]cpp$")
    if(vectors)
      set_property(SOURCE ${vectors} APPEND PROPERTY COMPILE_OPTIONS "-fno-sanitize=address")
    endif()
  endif()
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC ffgpu_options ${arg_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ffgpu_options ${arg_LINKS})
  endif()
endfunction()

# ffgpu_test(folder [LINKS ...]): one Catch2 program of all *_test.cpp files of tests/<folder>.
function(ffgpu_test folder)
  cmake_parse_arguments(arg "" "" "LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" name ${folder})
  add_executable(${name}_test ${sources})
  target_link_libraries(${name}_test PRIVATE catch_main ffgpu_options ${arg_LINKS})
  # What is tested is optimised; the tests' own code runs once, and is most of what there is to
  # compile. Half of that again is Catch2's header.
  target_compile_options(${name}_test PRIVATE $<$<CONFIG:Release>:-O1>)
  list(LENGTH sources count)
  if(count GREATER 3)
    target_precompile_headers(${name}_test PRIVATE <catch2/catch.hpp>)
    # So that ccache can keep what is compiled with it.
    target_compile_options(${name}_test PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
  target_compile_definitions(${name}_test PRIVATE FFGPU_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${name} COMMAND ${name}_test)
endfunction()
