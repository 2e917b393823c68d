// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "boxwood/core/vec.h"

namespace boxwood {

/// The part of a sphere around the point that the triangle (a, b, c) covers, 1 for all of it:
/// positive where the point sees its back, 0 where it lies in its plane. Source: van Oosterom and
/// Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30(2), 1983.
inline double solid_angle(const Vec3d& point, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d to_a = a - point, to_b = b - point, to_c = c - point;
    const double volume = to_a.dot((b - a).cross(c - a));
    if (volume == 0) return 0;
    const double la = to_a.norm(), lb = to_b.norm(), lc = to_c.norm();
    const double cosines =
        la * lb * lc + to_a.dot(to_b) * lc + to_b.dot(to_c) * la + to_c.dot(to_a) * lb;
    constexpr double kTwoPi = 6.283185307179586;
    return std::atan2(volume, cosines) / kTwoPi;
}

}  // namespace boxwood
