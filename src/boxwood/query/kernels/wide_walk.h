// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/simd.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Places on the stack of a walk. No tree that is collapsed needs more; see collapse.cpp.
constexpr int kStackSize = 4096;
/// Vectors are stored whole, so there is room for one beyond the end.
constexpr int kStackSlack = 16;

/// Whether a query has to look at all: a ray hits nothing when a coordinate of it isn't finite, its
/// direction has its largest coordinate outside [2^-60, 2^60], or not t_min <= t_max.
BOXWOOD_KERNEL bool is_traceable(const Rayf& ray) {
    float length = 0, sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float size = __builtin_fabsf(ray.direction[k]);
        if (size > length) length = size;
        sum += 0 * ray.origin[k] + 0 * ray.direction[k];  // NaN unless all are finite
    }
    return sum == 0 && length >= 0x1p-60f && length <= 0x1p60f && ray.t_min <= ray.t_max;
}

}  // namespace boxwood
