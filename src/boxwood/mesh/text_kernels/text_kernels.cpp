// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/text_kernels/text_kernels.h"

#include <cfloat>
#include <cmath>

#include "boxwood/mesh/text_numbers.h"

namespace boxwood {

const TextKernels& text_kernels(InstructionSet set) {
    switch (set) {
#if defined(__x86_64__)
        case InstructionSet::sse4:
            return sse4_text_kernels();
        case InstructionSet::avx2:
            return avx2_text_kernels();
        case InstructionSet::avx512:
            return avx512_text_kernels();
#elif defined(__aarch64__)
        case InstructionSet::neon:
            return neon_text_kernels();
#elif defined(__wasm__)
        case InstructionSet::wasm:
            return wasm_text_kernels();
#endif
        default:
            return scalar_text_kernels();
    }
}

bool read_unusual_row(const char*& at, const char* end, std::size_t columns, double* row) {
    const char* const newline = parse_plain_line(at, end, row, columns);
    if (!newline) return false;
    for (std::size_t k = 0; k < columns; ++k) {
        if (!(std::abs(row[k]) <= FLT_MAX)) return false;
    }
    at = newline + 1;
    return true;
}

}  // namespace boxwood
