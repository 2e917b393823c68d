// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "boxwood/core/vec.h"

namespace boxwood {

/// The nearest points that floats can hold. These lie in memory of their own: where a vector goes
/// to float and back at once, g++ 12 leaves out the rounding.
inline std::vector<Vec3d> rounded_to_float(std::span<const Vec3d> points) {
    std::vector<Vec3f> floats;
    floats.reserve(points.size());
    for (const Vec3d& p : points) floats.emplace_back(p.cast<float>());
    std::vector<Vec3d> result;
    result.reserve(points.size());
    for (const Vec3f& p : floats) result.emplace_back(p.cast<double>());
    return result;
}

}  // namespace boxwood
