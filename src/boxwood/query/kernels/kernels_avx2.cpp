// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx2.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& avx2_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Avx2>();
    return kKernels;
}

}  // namespace boxwood
