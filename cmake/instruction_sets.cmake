# Code that is compiled once for each instruction set, in a source of its own; which one runs is
# decided at run time. Those of the processor at hand, and the flags of each:
set(boxwood_instruction_sets scalar)
if(EMSCRIPTEN)
    list(APPEND boxwood_instruction_sets wasm)
    set(boxwood_flags_wasm -msimd128)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    list(APPEND boxwood_instruction_sets sse4 avx2 avx512)
    set(boxwood_flags_sse4 -msse4.1)
    set(boxwood_flags_avx2 -mavx2 -mfma -mbmi -mbmi2 -mlzcnt -mpopcnt)
    # GCC 12 takes the unused lanes of its own AVX-512 intrinsics for variables (its bug 105593).
    set(boxwood_flags_avx512 ${boxwood_flags_avx2} -mavx512f -mavx512bw -mavx512dq -mavx512vl
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
    list(APPEND boxwood_instruction_sets neon)
endif()

# boxwood_sources_per_instruction_set(TARGET PREFIX): the sources PREFIX_SET.cpp.
function(boxwood_sources_per_instruction_set target prefix)
    foreach(set ${boxwood_instruction_sets})
        target_sources(${target} PRIVATE ${prefix}_${set}.cpp)
        # Looking for pointers that wrap around takes as long again as all else that sanitizers do there.
        set_source_files_properties(${prefix}_${set}.cpp
            PROPERTIES COMPILE_OPTIONS "${boxwood_flags_${set}};$<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=pointer-overflow>"
            SKIP_PRECOMPILE_HEADERS ON)
    endforeach()
endfunction()
