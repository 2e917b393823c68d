// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_sse4.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& sse4_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Sse4>();
    return kKernels;
}

}  // namespace boxwood
