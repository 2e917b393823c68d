// SPDX-License-Identifier: Apache-2.0
// How far are the N triangles of a block from a point? In float it takes a place q on each triangle
// that is about the nearest. Its distance is a bound from above whatever rounding did to q. A bound
// from below is how far the plane through q, at right angles to the way there, is in front of all
// three corners: equal to the distance if q is nearest, less if it isn't, never more than that of
// the triangle. Explained in docs/algorithms/closest_point.md.
#pragma once

#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Three coordinates in every lane.
template <class S>
struct Vector {
    using Float = typename S::Float;

    Float x, y, z;

    friend BOXWOOD_KERNEL Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend BOXWOOD_KERNEL Float dot(const Vector& a, const Vector& b) {
        return S::multiply_add(a.x, b.x, S::multiply_add(a.y, b.y, a.z * b.z));
    }
    /// a + t b
    friend BOXWOOD_KERNEL Vector moved(const Vector& a, Float t, const Vector& b) {
        return {S::multiply_add(t, b.x, a.x), S::multiply_add(t, b.y, a.y),
                S::multiply_add(t, b.z, a.z)};
    }
};

template <class S>
BOXWOOD_KERNEL Vector<S> select(unsigned mask, const Vector<S>& a, const Vector<S>& b) {
    return {S::select(mask, a.x, b.x), S::select(mask, a.y, b.y), S::select(mask, a.z, b.z)};
}

/// The corners of the triangles of a block, from a point.
template <class S>
struct BlockCorners {
    Vector<S> a, b, c;

    BOXWOOD_KERNEL BlockCorners(const TriangleBlock<S::kWidth>& block, const Vector<S>& point)
        : a(corner(block, 0) - point), b(corner(block, 1) - point), c(corner(block, 2) - point) {}

private:
    static BOXWOOD_KERNEL Vector<S> corner(const TriangleBlock<S::kWidth>& block, int i) {
        return {S::load(block.corner[i][0]), S::load(block.corner[i][1]),
                S::load(block.corner[i][2])};
    }
};

/// The lanes whose triangle isn't wholly in front of the plane at right angles to the way to its
/// first corner, at the distance given squared: a look at whether a block is worth another.
template <class S>
BOXWOOD_KERNEL unsigned maybe_within(const BlockCorners<S>& from, typename S::Float squared) {
    const auto aa = dot(from.a, from.a);
    const auto least = S::min(S::min(aa, dot(from.a, from.b)), dot(from.a, from.c));
    return S::less_equal(least * S::max(least, S::broadcast(0)), squared * aa);
}

/// Bounds on the distance to triangles, but for the rounding of coordinates; NaN where there is no
/// triangle.
template <class S>
struct DistanceBounds {
    typename S::Float least, most;
};

template <class S>
BOXWOOD_KERNEL DistanceBounds<S> distance_bounds(const BlockCorners<S>& from) {
    using Float = typename S::Float;
    const Float zero = S::broadcast(0), one = S::broadcast(1);
    const auto clamped = [&](Float t) { return S::min(S::max(t, zero), one); };
    const Vector<S>&a = from.a, &b = from.b, &c = from.c;
    const Vector<S> ab = b - a, ac = c - a, bc = c - b;

    // The nearest places on the edges. Where an edge has no length, 0 / 0 becomes 0.
    const Float ab_ab = dot(ab, ab), ac_ac = dot(ac, ac), ab_ac = dot(ab, ac);
    const Float along_ab = -dot(a, ab), along_ac = -dot(a, ac);
    const Float inverse_ab = one / ab_ab;
    Vector<S> nearest = moved(a, clamped(along_ab * inverse_ab), ab);
    Float squared = dot(nearest, nearest);
    const auto offer = [&](const Vector<S>& place, unsigned lanes) {
        const Float other = dot(place, place);
        const unsigned nearer = S::less(other, squared) & lanes;
        nearest = select<S>(nearer, place, nearest);
        squared = S::select(nearer, other, squared);
    };
    offer(moved(a, clamped(along_ac / ac_ac), ac), ~0u);
    offer(moved(b, clamped(-dot(b, bc) / dot(bc, bc)), bc), ~0u);

    // Inside: ac less its part along ab is at right angles to ab.
    const Float shear = ab_ac * inverse_ab;
    const Float v = (along_ac - shear * along_ab) / (ac_ac - shear * ab_ac);
    const Float u = along_ab * inverse_ab - shear * v;
    const unsigned inside = S::less_equal(zero, S::min(u, v)) & S::less_equal(u + v, one);
    offer(moved(moved(a, u, ab), v, ac), inside);

    // Less than this loses digits to underflow.
    const Float most = S::sqrt(squared), divisor = S::max(most, S::broadcast(0x1p-62f));
    const Float least = S::min(S::min(dot(a, nearest), dot(b, nearest)), dot(c, nearest)) / divisor;
    const Float sides = ab_ab + ac_ac;
    const Float rounding = S::broadcast(0x1p-20f) * (most + S::sqrt(sides + sides));
    return {least - rounding, most + rounding};
}

}  // namespace boxwood
