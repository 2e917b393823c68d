// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_avx2.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& avx2_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<Avx2Bytes>();
    return kKernels;
}

}  // namespace boxwood
