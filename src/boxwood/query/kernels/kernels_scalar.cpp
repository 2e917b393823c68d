// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_scalar.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& scalar_kernels() {
    static constexpr RayKernels kKernels = {
        closest_hit<Scalar>,        any_hit<Scalar>,
        closest_hits<Scalar>,       any_hits<Scalar>,
        walk_candidates<Scalar>,    walk_near_triangles<Scalar>,
        walk_overlaps<Scalar>,      closest_hit<Scalar, WideCounts>,
        any_hit<Scalar, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
