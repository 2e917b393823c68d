// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/simd.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Outside these a ray hits nothing, so that no product below overflows.
constexpr float kShortestDirection = 0x1p-40f, kLongestDirection = 0x1p40f;  ///< largest coordinate
constexpr float kFarthestOrigin = 0x1p57f;
/// Smaller coordinates of a direction count as this: at most 2^-28 of the largest.
constexpr float kLeastSlope = 0x1p-68f;

/// Whether a query has to look at all: a ray hits nothing when a coordinate of it is NaN or beyond
/// the limits above, or not t_min <= t_max.
template <class Quad>
BOXWOOD_KERNEL bool is_traceable(const Rayf& ray) {
    const auto direction = Quad::abs(Quad::load_unaligned(ray.direction));
    const auto origin = Quad::abs(Quad::load_unaligned(ray.origin));
    const unsigned is_near = Quad::less_equal(origin, Quad::broadcast(kFarthestOrigin)) &
                             Quad::less_equal(direction, Quad::broadcast(kLongestDirection));
    const unsigned is_long = Quad::less_equal(Quad::broadcast(kShortestDirection), direction);
    return ((is_near & 7) == 7) & ((is_long & 7) != 0) & (ray.t_min <= ray.t_max);
}

/// All that the tests against boxes and triangles need of a ray, worked out once.
struct RaySetup {
    // For boxes; the fourth numbers are idle.
    alignas(16) float inverse[4];    ///< of the direction
    alignas(16) float near_term[4];  ///< a near face at p is reached at p * inverse + near_term
    alignas(16) float far_term[4];
    float rounding;        ///< by which boxes are moved outward
    std::uint32_t octant;  ///< bit k says that the direction is negative along axis k

    // For triangles.
    std::uint32_t kx, ky, kz;  ///< axes, renamed so that |direction[kz]| is largest
    float ox, oy, oz;          ///< the origin along them
    float sx, sy, sz;          ///< the shear
    float t_min;

    /// The extra rounding is how far off the ray may be besides its own rounding to float.
    /// Precondition: is_traceable(ray).
    template <class Quad>
    BOXWOOD_KERNEL void set(const Rayf& ray, const WideTreeView& tree, float extra_rounding = 0) {
        const auto origin = Quad::load_unaligned(ray.origin);
        const auto direction = Quad::load_unaligned(ray.direction);
        // A zero coordinate of the direction would make 0 * infinity; one so small that it moves
        // the ray by less than the rounding does not.
        const auto size = Quad::max(Quad::abs(direction), Quad::broadcast(kLeastSlope));
        const auto reciprocal = Quad::broadcast(1) / Quad::copy_sign(size, direction);

        // The origin is moved outward by a bound on all rounding: see docs/algorithms/ray_box.md.
        // Each step here delays the first node, so it is made of the one largest coordinate that
        // takes part.
        const auto extent = Quad::max(Quad::abs(Quad::load_unaligned(tree.lo)),
                                      Quad::abs(Quad::load_unaligned(tree.hi)));
        const auto farthest = Quad::largest_of_three(Quad::max(Quad::abs(origin), extent));
        auto bound = Quad::broadcast(0x1p-18f) * farthest;
        if (extra_rounding != 0) bound = bound + Quad::broadcast(extra_rounding);
        const auto outward = Quad::copy_sign(bound, direction);
        alignas(16) float bounds[4];
        Quad::store(bounds, bound);
        rounding = bounds[0];
        const auto opposite = -reciprocal;
        Quad::store(inverse, reciprocal);
        Quad::store(near_term, (origin + outward) * opposite);
        Quad::store(far_term, (origin - outward) * opposite);
        octant = Quad::signs(direction) & 7;

        // The first of the largest coordinates. Compilers make branches of comparisons and a table
        // in memory of an array, hence the bits.
        const auto length = Quad::abs(direction);
        const unsigned longest = Quad::equal(length, Quad::largest_of_three(length));
        kz = static_cast<std::uint32_t>(__builtin_ctz(longest));
        kx = 0b00'10'01u >> (2 * kz) & 3;
        ky = 0b01'00'10u >> (2 * kz) & 3;
        ox = ray.origin[kx];
        oy = ray.origin[ky];
        oz = ray.origin[kz];
        sz = inverse[kz];
        sx = ray.direction[kx] * sz;
        sy = ray.direction[ky] * sz;
        t_min = ray.t_min;
    }
};

}  // namespace boxwood
