// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& ray_kernels(InstructionSet set) {
    switch (set) {
#if defined(__x86_64__)
        case InstructionSet::sse4:
            return sse4_kernels();
        case InstructionSet::avx2:
            return avx2_kernels();
        case InstructionSet::avx512:
            return avx512_kernels();
#elif defined(__aarch64__)
        case InstructionSet::neon:
            return neon_kernels();
#elif defined(__wasm__)
        case InstructionSet::wasm:
            return wasm_kernels();
#endif
        default:
            return scalar_kernels();
    }
}

}  // namespace boxwood
