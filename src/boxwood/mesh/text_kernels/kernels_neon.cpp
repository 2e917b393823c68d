// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_neon.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& neon_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<NeonBytes>();
    return kKernels;
}

}  // namespace boxwood
