// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "boxwood/core/box.h"

namespace boxwood {

/// A power of two that brings all coordinates of a box into [-2, 2], so that areas and volumes in
/// float neither overflow nor vanish. Scaling by it rounds nothing.
inline float unit_scale(const Box3f& bounds) {
    if (bounds.is_empty()) return 1;
    const float largest = bounds.lo.cwiseAbs().cwiseMax(bounds.hi.cwiseAbs()).maxCoeff();
    if (largest == 0) return 1;
    return std::ldexp(1.0f, std::clamp(-std::ilogb(largest), -126, 126));
}

/// The same for all of the boxes.
inline float unit_scale(std::span<const Box3f> boxes) {
    Box3f bounds;
    for (const Box3f& box : boxes) bounds.extend(box);
    return unit_scale(bounds);
}

}  // namespace boxwood
