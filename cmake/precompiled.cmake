# What nearly every source includes is parsed once for each target: half the time to build. It hides
# includes that are missing, so lint goes without.
option(BOXWOOD_PRECOMPILED_HEADERS "Parse the headers that all sources share once" ${PROJECT_IS_TOP_LEVEL})

# boxwood_precompile(TARGET HEADER...), or boxwood_precompile(TARGET REUSE_FROM OTHER). The options that
# matter to the headers have to be the same for both: those of the language and the machine, not -O.
function(boxwood_precompile target)
    if(BOXWOOD_PRECOMPILED_HEADERS)
        if("${ARGV1}" STREQUAL "REUSE_FROM")
            target_precompile_headers(${target} ${ARGN})
        else()
            target_precompile_headers(${target} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm>
                <cmath> <cstdint> <filesystem> <limits> <optional> <span> <string> <string_view> <vector>
                ${ARGN})
        endif()
        # GCC 12 then warns of overflows in std::string where there are none.
        target_compile_options(${target} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
        # So that ccache can tell what is in them.
        target_compile_options(${target} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
            "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
    endif()
endfunction()
