// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/core/vec.h"

namespace boxwood {

/// How far the point is from the triangle, in long double and by another way than the library: the
/// least of the distances to the edges and, where the point is above it, to the plane, found by
/// making the sides orthogonal to each other.
inline long double distance_in_long_double(const Vec3d& point, const Vec3d& a, const Vec3d& b,
                                           const Vec3d& c) {
    using Vec = Eigen::Matrix<long double, 3, 1>;
    using Scalar = long double;
    const Vec p = point.cast<Scalar>();
    const Vec corner[3] = {a.cast<Scalar>(), b.cast<Scalar>(), c.cast<Scalar>()};
    Scalar least = std::numeric_limits<Scalar>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Vec from = corner[k], along = corner[(k + 1) % 3] - from;
        const Scalar length = along.norm();
        const Vec unit = length > 0 ? Vec(along / length) : Vec(Vec::Zero());
        const Scalar t = std::clamp<Scalar>(unit.dot(p - from), 0, length);
        least = std::min(least, (p - from - t * unit).norm());
    }
    const Vec ab = corner[1] - corner[0], ac = corner[2] - corner[0], ap = p - corner[0];
    const Scalar width = ab.norm();
    if (!(width > 0)) return least;
    const Vec x = ab / width;
    const Vec up = ac - x.dot(ac) * x;
    const Scalar height = up.norm();
    if (!(height > 1e-17L * ac.norm())) return least;
    const Vec y = up / height;
    const Scalar of_c = y.dot(ap) / height;
    const Scalar of_b = (x.dot(ap) - of_c * x.dot(ac)) / width;
    if (of_b >= 0 && of_c >= 0 && of_b + of_c <= 1)
        least = std::min(least, (ap - x.dot(ap) * x - y.dot(ap) * y).norm());
    return least;
}

}  // namespace boxwood
