// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx512.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& avx512_kernels() {
    static constexpr RayKernels kKernels = {
        closest_hit<Avx512>,        any_hit<Avx512>,
        closest_hits<Avx512>,       any_hits<Avx512>,
        walk_candidates<Avx512>,    walk_near_triangles<Avx512>,
        walk_overlaps<Avx512>,      closest_hit<Avx512, WideCounts>,
        any_hit<Avx512, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
