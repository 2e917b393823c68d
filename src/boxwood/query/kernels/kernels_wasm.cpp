// SPDX-License-Identifier: Apache-2.0
#if defined(__wasm__)  // linters come by on other machines too
#include "boxwood/core/simd_wasm.h"
#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

const RayKernels& wasm_kernels() {
    static constexpr RayKernels kKernels = {closest_hit<Wasm>,        any_hit<Wasm>,
                                            closest_hits<Wasm>,       any_hits<Wasm>,
                                            walk_candidates<Wasm>,    walk_near_triangles<Wasm>,
                                            walk_overlaps<Wasm>,      closest_hit<Wasm, WideCounts>,
                                            any_hit<Wasm, WideCounts>};
    return kKernels;
}

}  // namespace boxwood
#endif
