// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_scalar.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& scalar_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<ScalarBytes>();
    return kKernels;
}

}  // namespace boxwood
