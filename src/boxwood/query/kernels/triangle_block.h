// SPDX-License-Identifier: Apache-2.0
// Does a ray hit any of the N triangles of a block? The watertight test of core/ray_triangle.h in
// float, N triangles at a time, with the same bits on every instruction set.
// Edge functions have an error of at most 1.5 units in the last place, hence exact signs. Where a
// fused multiply-add has to be emulated, plain arithmetic comes first: rounding keeps the order of
// two products, so their difference may come out as zero but never with the wrong sign, and who is
// outside by that is outside. Explained in docs/algorithms/wide_tree.md.
#pragma once

#include "boxwood/query/kernels/ray_setup.h"

namespace boxwood {

/// Below this the products that make it up have lost digits to underflow.
constexpr float kLeastDeterminant = 0x1p-100f;

/// Which lanes of a block are hit within [t_min, t_max], and where: t, and the weights of the
/// corners b and c times the determinant. Only lanes of the mask mean anything.
template <class S>
struct BlockHit {
    unsigned mask;
    typename S::Float t, v, w, determinant;
};

/// A corner moved to the ray's origin and sheared so that the ray is the z axis; z is left
/// unscaled.
template <class S>
struct ShearedCorner {
    using Float = typename S::Float;

    Float x, y, z;

    /// The corner's place from the origin, along kx, ky and kz.
    BOXWOOD_KERNEL ShearedCorner(Float from_x, Float from_y, Float from_z, Float sx, Float sy)
        : x(from_x - sx * from_z), y(from_y - sy * from_z), z(from_z) {}
    /// What is the same in all lanes is read where it is needed, which most instruction sets do for
    /// nothing: half of the rays come to no block or one.
    BOXWOOD_KERNEL ShearedCorner(const float (&corner)[3][S::kWidth], const RaySetup& ray)
        : ShearedCorner(S::load(corner[ray.kx]) - S::broadcast(ray.ox),
                        S::load(corner[ray.ky]) - S::broadcast(ray.oy),
                        S::load(corner[ray.kz]) - S::broadcast(ray.oz), S::broadcast(ray.sx),
                        S::broadcast(ray.sy)) {}
};

/// a b - c d with an error of at most 1.5 units in the last place, given c d rounded.
/// Source: Jeannerod, Louvet and Muller, "Further analysis of Kahan's algorithm for the accurate
/// computation of 2x2 determinants", Math. Comp. 82, 2013.
template <class S>
BOXWOOD_KERNEL typename S::Float difference_of_products(typename S::Float a, typename S::Float b,
                                                        typename S::Float c, typename S::Float d,
                                                        typename S::Float cd) {
    return S::fused(a, b, -cd) + S::fused(-c, d, cd);
}

/// Whether the origin is inside, by the signs of the edge functions.
template <class S>
BOXWOOD_KERNEL unsigned inside(typename S::Float u, typename S::Float v, typename S::Float w) {
    const auto zero = S::broadcast(0);
    return S::less_equal(zero, S::min(S::min(u, v), w)) |
           S::less_equal(S::max(S::max(u, v), w), zero);
}

/// The test proper; in each lane a ray and a triangle. With kEarlyOut it branches where all miss.
template <class S, bool kEarlyOut = false>
BOXWOOD_KERNEL BlockHit<S> intersect(const ShearedCorner<S>& a, const ShearedCorner<S>& b,
                                     const ShearedCorner<S>& c, typename S::Float sz,
                                     typename S::Float t_min, typename S::Float t_max) {
    using Float = typename S::Float;
    const Float cy_bx = c.y * b.x, ay_cx = a.y * c.x, by_ax = b.y * a.x;
    BlockHit<S> hit;
    if constexpr (!S::kFastFused) {
        hit.mask = inside<S>(c.x * b.y - cy_bx, a.x * c.y - ay_cx, b.x * a.y - by_ax);
        if (hit.mask == 0) return hit;
    }
    const Float u = difference_of_products<S>(c.x, b.y, c.y, b.x, cy_bx);
    const Float v = difference_of_products<S>(a.x, c.y, a.y, c.x, ay_cx);
    const Float w = difference_of_products<S>(b.x, a.y, b.y, a.x, by_ax);
    hit.mask = inside<S>(u, v, w);
    if (kEarlyOut && hit.mask == 0) return hit;

    const Float determinant = (u + v) + w;
    const Float least = S::broadcast(kLeastDeterminant);
    hit.mask &= S::less_equal(least, S::max(determinant, -determinant));
    // The weights have one sign, so this is a mean of the corners' distances, not a cancellation.
    hit.t = ((u * (sz * a.z) + v * (sz * b.z)) + w * (sz * c.z)) / determinant;
    hit.mask &= S::less_equal(t_min, hit.t) & S::less_equal(hit.t, t_max);
    hit.v = v;
    hit.w = w;
    hit.determinant = determinant;
    return hit;
}

/// One ray and the triangles of a block.
template <class S>
BOXWOOD_KERNEL BlockHit<S> intersect(const TriangleBlock<S::kWidth>& block, const RaySetup& ray,
                                     typename S::Float t_max) {
    const ShearedCorner<S> a(block.corner[0], ray), b(block.corner[1], ray),
        c(block.corner[2], ray);
    return intersect<S>(a, b, c, S::broadcast(ray.sz), S::broadcast(ray.t_min), t_max);
}

}  // namespace boxwood
