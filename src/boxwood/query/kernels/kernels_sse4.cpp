// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_sse4.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& sse4_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Sse4>,        any_hit<Sse4>,
                                            closest_hits<Sse4>,       any_hits<Sse4>,
                                            walk_candidates<Sse4>,    walk_near_triangles<Sse4>,
                                            walk_overlaps<Sse4>,      closest_hit<Sse4, WideCounts>,
                                            any_hit<Sse4, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
