// SPDX-License-Identifier: Apache-2.0
// Does a ray hit a sphere? Where the ray's line comes closest to the centre tells by Pythagoras how
// far before and behind that point it crosses the surface. Taken from the closest point, not from
// the textbook's quadratic, small far spheres lose no digits to cancellation.
// Source: Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems, 2019.
#pragma once

#include <cmath>
#include <optional>

#include "boxwood/core/ray.h"

namespace boxwood {

/// The least t in [ray.t_min, ray.t_max] at which the ray crosses the sphere, from either side. A
/// ray that starts on the surface doesn't see the point that it starts from.
inline std::optional<double> intersect_sphere(const Ray& ray, const Vec3d& center, double radius,
                                              bool starts_on_surface) {
    const Vec3d to_center = center - ray.origin;
    const double direction_squared = ray.direction.squaredNorm();
    const double t_closest = to_center.dot(ray.direction) / direction_squared;
    if (starts_on_surface) {
        const double t = 2 * t_closest;
        return t > 0 && ray.t_min <= t && t <= ray.t_max ? std::optional(t) : std::nullopt;
    }
    const double off_center_squared = (to_center - t_closest * ray.direction).squaredNorm();
    const double half_chord_squared = radius * radius - off_center_squared;
    if (!(half_chord_squared >= 0)) return std::nullopt;
    const double half_chord = std::sqrt(half_chord_squared / direction_squared);
    for (const double t : {t_closest - half_chord, t_closest + half_chord}) {
        if (ray.t_min <= t && t <= ray.t_max) return t;
    }
    return std::nullopt;
}

}  // namespace boxwood
