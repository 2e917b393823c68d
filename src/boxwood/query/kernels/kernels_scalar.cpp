// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_scalar.h"
#include "boxwood/query/kernels/any_hit.h"
#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& scalar_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Scalar>, any_hit<Scalar>};
    return kKernels;
}

}  // namespace boxwood
