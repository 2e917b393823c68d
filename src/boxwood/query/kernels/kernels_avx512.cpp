// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx512.h"
#include "boxwood/query/kernels/any_hit.h"
#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& avx512_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Avx512>, any_hit<Avx512>};
    return kKernels;
}

}  // namespace boxwood
