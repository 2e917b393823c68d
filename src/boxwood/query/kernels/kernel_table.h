// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/kernels/batch.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

/// All kernels, for the instruction set of S. Only the source file that is compiled for it may ask.
template <class S>
constexpr RayKernels kernels_of() {
    return {closest_hit<S>,
            any_hit<S>,
            closest_hits<S>,
            any_hits<S>,
            closest_hits_in_columns<S>,
            any_hits_in_columns<S>,
            walk_candidates<S>,
            closest_candidates<S>,
            any_candidates<S>,
            walk_near_triangles<S>,
            walk_overlaps<S>,
            closest_hit<S, WideCounts>,
            any_hit<S, WideCounts>};
}

}  // namespace boxwood
