// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx2.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& avx2_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Avx2>,        any_hit<Avx2>,
                                            closest_hits<Avx2>,       any_hits<Avx2>,
                                            walk_candidates<Avx2>,    walk_near_triangles<Avx2>,
                                            walk_overlaps<Avx2>,      closest_hit<Avx2, WideCounts>,
                                            any_hit<Avx2, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
