// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_sse4.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& sse4_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<Sse4Bytes>();
    return kKernels;
}

}  // namespace boxwood
