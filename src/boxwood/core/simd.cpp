// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd.h"

#include <cstdlib>

namespace boxwood {

std::span<const Named<InstructionSet>> instruction_sets() {
    static constexpr Named<InstructionSet> kSets[] = {
        {"scalar", InstructionSet::scalar},
#if defined(__x86_64__)
        {"sse4", InstructionSet::sse4},
        {"avx2", InstructionSet::avx2},
        {"avx512", InstructionSet::avx512},
#elif defined(__aarch64__)
        {"neon", InstructionSet::neon},
#elif defined(__wasm__)
        {"wasm", InstructionSet::wasm},
#endif
    };
    return kSets;
}

bool is_supported(InstructionSet set) {
    switch (set) {
        case InstructionSet::scalar:
            return true;
#if defined(__x86_64__)
        case InstructionSet::sse4:
            return __builtin_cpu_supports("sse4.1");
        case InstructionSet::avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                   __builtin_cpu_supports("bmi2");
        case InstructionSet::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                   is_supported(InstructionSet::avx2);
#elif defined(__aarch64__)
        case InstructionSet::neon:
            return true;
#elif defined(__wasm__)
        // A machine without it wouldn't have accepted the program.
        case InstructionSet::wasm:
            return true;
#endif
        default:
            return false;
    }
}

InstructionSet preferred_instruction_set() {
    static const InstructionSet kPreferred = [] {
        const char* wanted = std::getenv("BOXWOOD_ISA");
        InstructionSet best = InstructionSet::scalar;
        for (const auto& [name, set] : instruction_sets()) {
            if (!is_supported(set)) continue;
            if (wanted && name == wanted) return set;
            best = set;
        }
        return best;
    }();
    return kPreferred;
}

}  // namespace boxwood
