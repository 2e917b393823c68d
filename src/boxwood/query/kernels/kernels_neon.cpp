// SPDX-License-Identifier: Apache-2.0
#if defined(__aarch64__)  // linters come by on other machines too
#include "boxwood/core/simd_neon.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& neon_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Neon>,        any_hit<Neon>,
                                            closest_hits<Neon>,       any_hits<Neon>,
                                            walk_candidates<Neon>,    walk_near_triangles<Neon>,
                                            walk_overlaps<Neon>,      closest_hit<Neon, WideCounts>,
                                            any_hit<Neon, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
#endif
