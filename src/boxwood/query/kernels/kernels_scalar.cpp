// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_scalar.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& scalar_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Scalar>();
    return kKernels;
}

}  // namespace boxwood
