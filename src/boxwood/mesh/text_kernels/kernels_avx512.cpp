// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_avx512.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& avx512_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<Avx512Bytes>();
    return kKernels;
}

}  // namespace boxwood
