// SPDX-License-Identifier: Apache-2.0
// Does a ray hit a box? The slab test: between each pair of parallel faces the ray spends an
// interval of t; it hits the box when the three intervals overlap. Constant time, no division.
// The boxes are moved outward by a bound on every rounding error, here and in the triangle test, so
// a box is never missed when a triangle in it is hit.
// Sources: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; Ize, "Robust BVH Ray
// Traversal", JCGT 2(2), 2013. Explained in docs/algorithms/ray_box.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/core/box.h"
#include "boxwood/core/ray.h"

namespace boxwood {

/// The part of the test that depends on the ray alone; made once a ray and tree.
class SlabRay {
public:
    /// Where intersect() says that the ray misses the box.
    static constexpr double kMiss = std::numeric_limits<double>::infinity();

    /// The bounds contain every box that will be asked for. The ray may be off by so much from the
    /// one that is meant. Precondition: is_traceable(ray).
    SlabRay(const Ray& ray, const Box3f& bounds, double off = 0) {
        // Both tests round coordinates relative to the origin, at most reach in size, and together
        // move what they see by up to 22 times half of 2^-52; docs/algorithms/ray_box.md adds that
        // up. The origin's own size keeps the small number from vanishing in the sums below.
        const Vec3d lo = bounds.lo.cast<double>() - ray.origin;
        const Vec3d hi = bounds.hi.cast<double>() - ray.origin;
        const double reach = lo.cwiseAbs().cwiseMax(hi.cwiseAbs()).maxCoeff();
        const double rounding = 16 * 0x1p-52 * (reach + ray.origin.lpNorm<Eigen::Infinity>()) + off;

        // A zero coordinate of the direction would make 0 * infinity; one so small that it moves
        // the ray by less than the rounding does not.
        const double tiny = 0x1p-100 * ray.direction.lpNorm<Eigen::Infinity>();
        for (int k = 0; k < 3; ++k) {
            const double d = ray.direction[k];
            inverse_[k] = 1 / (std::abs(d) < tiny ? std::copysign(tiny, d) : d);
            negative_[k] = std::signbit(d);
            lo_origin_[k] = ray.origin[k] + rounding;
            hi_origin_[k] = ray.origin[k] - rounding;
        }
    }

    /// The distance at which the ray enters the box, t_min if it starts inside; kMiss if there is
    /// none in [t_min, t_max].
    double intersect(const Box3f& box, double t_min, double t_max) const {
        for (int k = 0; k < 3; ++k) {
            const double to_lo = (box.lo[k] - lo_origin_[k]) * inverse_[k];
            const double to_hi = (box.hi[k] - hi_origin_[k]) * inverse_[k];
            t_min = std::max(t_min, negative_[k] ? to_hi : to_lo);
            t_max = std::min(t_max, negative_[k] ? to_lo : to_hi);
        }
        return t_min <= t_max ? t_min : kMiss;
    }

private:
    Vec3d inverse_;
    Vec3d lo_origin_;  ///< of the lower faces
    Vec3d hi_origin_;  ///< of the upper faces
    bool negative_[3];
};

}  // namespace boxwood
