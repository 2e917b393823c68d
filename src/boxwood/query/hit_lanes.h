// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "boxwood/core/ray_triangle.h"
#include "boxwood/core/simd.h"

namespace boxwood {

/// Rays and triangles that they are likely to hit: the test of core/ray_triangle.h in double, for
/// kLanes of them at a time. Compilers make vectors of its loops.
class HitLanes {
public:
    static constexpr int kLanes = 8;

    /// Precondition: is_traceable(ray).
    BOXWOOD_KERNEL void set(int lane, const Ray& ray, const Vec3d& a, const Vec3d& b,
                            const Vec3d& c) {
        const ShearAxes axes(ray.direction);
        const int along[3] = {axes.kx, axes.ky, axes.kz};
        for (int k = 0; k < 3; ++k) {
            const double origin = ray.origin[along[k]];
            a_[k][lane] = a[along[k]] - origin;
            b_[k][lane] = b[along[k]] - origin;
            c_[k][lane] = c[along[k]] - origin;
            direction_[k][lane] = ray.direction[along[k]];
        }
        t_min_[lane] = ray.t_min;
        t_max_[lane] = ray.t_max;
    }

    /// Makes the tests. Where is_hit(lane) then, the triangle is hit well inside, at t, u and v
    /// that have the bits of intersect(), and where is_missed(lane), it isn't. Else it has to be
    /// asked.
    BOXWOOD_KERNEL void test() {
        for (int i = 0; i < kLanes; ++i) {
            const double sx = direction_[0][i] / direction_[2][i];
            const double sy = direction_[1][i] / direction_[2][i];
            const double sz = 1 / direction_[2][i];
            const double ax = a_[0][i] - sx * a_[2][i], ay = a_[1][i] - sy * a_[2][i];
            const double bx = b_[0][i] - sx * b_[2][i], by = b_[1][i] - sy * b_[2][i];
            const double cx = c_[0][i] - sx * c_[2][i], cy = c_[1][i] - sy * c_[2][i];
            const double at_a = difference_of_products(cx, by, cy, bx);
            const double at_b = difference_of_products(ax, cy, ay, cx);
            const double at_c = difference_of_products(bx, ay, by, ax);
            const double sum = at_a + at_b + at_c;
            const double distance =
                (at_a * (sz * a_[2][i]) + at_b * (sz * b_[2][i]) + at_c * (sz * c_[2][i])) / sum;
            const double least = std::min(std::min(at_a, at_b), at_c),
                         most = std::max(std::max(at_a, at_b), at_c);
            const bool inside = (least > kSureEdge) | (most < -kSureEdge);
            const bool outside = (least < -kSureEdge) & (most > kSureEdge);
            const bool in_range = (t_min_[i] <= distance) & (distance <= t_max_[i]);
            hit_[i] = inside & in_range ? 1 : 0;
            missed_[i] = outside | (inside & !in_range) ? 1 : 0;
            t[i] = distance;
            u[i] = at_b / sum;
            v[i] = at_c / sum;
        }
    }

    bool is_hit(int lane) const { return hit_[lane] != 0; }
    bool is_missed(int lane) const { return missed_[lane] != 0; }

    alignas(64) double t[kLanes], u[kLanes], v[kLanes];

private:
    // From the origin, along the axes of the shear.
    alignas(64) double a_[3][kLanes], b_[3][kLanes], c_[3][kLanes];
    alignas(64) double direction_[3][kLanes], t_min_[kLanes], t_max_[kLanes];
    alignas(64) double hit_[kLanes], missed_[kLanes];
};

}  // namespace boxwood
