// SPDX-License-Identifier: Apache-2.0
// How far rays and triangles in float are from those in double: see
// docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/ray_setup.h"

namespace boxwood {

/// How far off sheared coordinates of triangles are at the most, and what the ray may be off by
/// besides. Half of the rounding that boxes need is more than that of sheared coordinates.
BOXWOOD_KERNEL float candidate_error(const RaySetup& ray, float extra_rounding = 0) {
    return 0.5f * ray.rounding + 1.5f * extra_rounding;
}

/// What is beyond this distance, given all that it may be off by, is beyond t_min in double; with
/// t_max, what is before it.
BOXWOOD_KERNEL float surely_beyond(float t_min, float error) {
    const float size = __builtin_fabsf(t_min);
    return size < __builtin_inff() ? t_min + (0x1p-22f * size + 4 * error) : t_min;
}
BOXWOOD_KERNEL float surely_before(float t_max, float error) {
    return -surely_beyond(-t_max, error);
}

}  // namespace boxwood
