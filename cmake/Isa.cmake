# Kernels compiled once more for a wider instruction set, in one binary with the others.
#
# An inline function, ours or the standard library's, is emitted in every object that uses it, and
# the linker keeps any one of them: it might keep the one compiled for AVX-512 and call it on a
# processor that has none. So all objects of an instruction set are linked into one relocatable
# object, and there every symbol but the entries is made local (tests/isa/symbols_test.cpp checks
# it): nothing is left to merge.
include(CheckCXXCompilerFlag)

set(isas "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT ALHAZEN_SANITIZE AND CMAKE_OBJCOPY)
  set(isas avx2 avx512)
endif()
set(ALHAZEN_ISAS "${isas}" CACHE STRING "instruction sets besides the baseline: avx2 and avx512")

# What src/render/wave/isa.cpp asks the processor for. Spelled out where a level would do: clang and
# gcc agree on these. F16C, LZCNT and MOVBE of x86-64-v3 are left out, as they are of no use here.
set(flags_of_avx2 -mavx2 -mfma -mbmi -mbmi2 -mpopcnt)
set(flags_of_avx512 ${flags_of_avx2} -mavx512f -mavx512bw -mavx512cd -mavx512dq -mavx512vl)

# A stage is hundreds of small functions of lanes, an instruction or a few each, which are to leave no
# calls behind. By itself g++ stops inlining when a file has grown by so much, and then what one stage
# costs depends on what other stages are in the file.
set(ALHAZEN_INLINE_ALL "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(ALHAZEN_INLINE_ALL
    --param=inline-unit-growth=400 --param=large-function-growth=1000
    --param=large-unit-insns=100000 --param=max-inline-insns-single=400
    --param=max-inline-insns-auto=60)
endif()

# alhazen_isa_kernels(TARGET ROOMS room ... SOURCES a.cpp ...): adds to TARGET, for each of
# ALHAZEN_ISAS, the sources of the rooms and those named, compiled with its flags and with
# ALHAZEN_ISA_NAME set to its name. What stays visible are the functions in the namespace of that name.
function(alhazen_isa_kernels target)
  cmake_parse_arguments(KERNELS "" "" "ROOMS;SOURCES" ${ARGN})
  set(sources ${KERNELS_SOURCES})
  foreach(room ${KERNELS_ROOMS})
    get_target_property(type ${room} TYPE)
    if(type STREQUAL "INTERFACE_LIBRARY")
      continue()
    endif()
    get_target_property(folder ${room} SOURCE_DIR)
    get_target_property(files ${room} SOURCES)
    foreach(file ${files})
      if(NOT file MATCHES "quad")  # the oracle has no lanes
        list(APPEND sources ${folder}/${file})
      endif()
    endforeach()
  endforeach()
  foreach(isa avx2 avx512)
    string(TOUPPER ${isa} upper)
    if(NOT isa IN_LIST ALHAZEN_ISAS)
      target_compile_definitions(${target} PRIVATE ALHAZEN_HAS_${upper}=0)
      continue()
    endif()
    target_compile_definitions(${target} PRIVATE ALHAZEN_HAS_${upper}=1)
    set(objects ${target}_${isa})
    add_library(${objects} OBJECT ${sources})
    target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR}/src
                                                  ${PROJECT_BINARY_DIR}/generated)
    target_link_libraries(${objects} PRIVATE alhazen_options nlohmann_json::nlohmann_json fmt::fmt)
    target_compile_options(${objects} PRIVATE ${flags_of_${isa}} ${ALHAZEN_INLINE_ALL}
      $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
    target_compile_definitions(${objects} PRIVATE ALHAZEN_ISA_NAME=${isa} ALHAZEN_WITHOUT_QUAD)
    set(whole ${CMAKE_CURRENT_BINARY_DIR}/${objects}_whole.o)
    set(sealed ${CMAKE_CURRENT_BINARY_DIR}/${objects}.o)
    add_custom_command(OUTPUT ${sealed}
      COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${whole} $<TARGET_OBJECTS:${objects}>
      COMMAND ${CMAKE_OBJCOPY} --wildcard
              --keep-global-symbol=_ZN7alhazen6render*${isa}*render_in_* ${whole} ${sealed}
      DEPENDS $<TARGET_OBJECTS:${objects}> ${objects}
      COMMENT "Sealing the kernels for ${isa}"
      COMMAND_EXPAND_LISTS VERBATIM)
    set_source_files_properties(${sealed} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
    target_sources(${target} PRIVATE ${sealed})
    set_property(TARGET ${target} APPEND PROPERTY ALHAZEN_SEALED_OBJECTS ${sealed})
  endforeach()
endfunction()
