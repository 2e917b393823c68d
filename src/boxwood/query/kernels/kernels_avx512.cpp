// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx512.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& avx512_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Avx512>();
    return kKernels;
}

}  // namespace boxwood
