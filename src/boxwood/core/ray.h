// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "boxwood/core/vec.h"

namespace boxwood {

/// Names a triangle of a scene: the instance by its place in the scene, the triangle by the face
/// index in its mesh.
struct TriangleId {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t instance = kNone;
    std::uint32_t triangle = kNone;

    friend bool operator==(const TriangleId&, const TriangleId&) = default;
};

/// The points origin + t * direction with t_min <= t <= t_max. The direction need not have unit
/// length; distances t are in multiples of it.
struct Ray {
    Vec3d origin = Vec3d::Zero();
    Vec3d direction = Vec3d(0, 0, -1);
    double t_min = 0;
    double t_max = std::numeric_limits<double>::infinity();
    /// A triangle that this ray doesn't see: the one it starts on, so that no epsilon is needed.
    TriangleId skip = {};
    /// It sees the instances of a scene whose mask has a bit of it.
    std::uint32_t visibility = ~std::uint32_t{0};

    Vec3d at(double t) const { return origin + t * direction; }
};

/// Where a ray meets a triangle (a, b, c): at ray.at(t), or (1 - u - v) a + u b + v c. Where hits
/// stand in arrays, a ray that hits nothing has Hit{}: t = infinity and triangle =
/// TriangleId::kNone.
struct Hit {
    double t = std::numeric_limits<double>::infinity();
    double u = 0;
    double v = 0;
    std::uint32_t triangle = TriangleId::kNone;
    std::uint32_t instance = 0;

    bool is_hit() const { return triangle != TriangleId::kNone; }
};

/// The order of hits along a ray. Equal distances go to the lower (instance, triangle) index, so
/// that the closest hit doesn't depend on the order in which a tree is walked.
inline bool is_closer(const Hit& a, const Hit& b) {
    if (a.t != b.t) return a.t < b.t;
    return a.instance != b.instance ? a.instance < b.instance : a.triangle < b.triangle;
}

/// Whether a query has to look at all: a ray hits nothing when a coordinate of it isn't finite,
/// its direction is zero or has its largest coordinate outside [1e-150, 1e150], or t_min > t_max.
inline bool is_traceable(const Ray& ray) {
    const Vec3d size = ray.direction.cwiseAbs();
    const double length = std::max(std::max(size[0], size[1]), size[2]);
    // Zero, or NaN when one of them isn't finite: one branch for all.
    const double zero = 0 * ray.origin[0] + 0 * ray.origin[1] + 0 * ray.origin[2] +
                        0 * ray.direction[0] + 0 * ray.direction[1] + 0 * ray.direction[2];
    return (zero == 0) & (length >= 1e-150) & (length <= 1e150) & (ray.t_min <= ray.t_max);
}

}  // namespace boxwood
