// SPDX-License-Identifier: Apache-2.0
// Which triangles might be nearest to a point? The walk goes to the nearest box first and leaves
// out boxes beyond the nearest triangle so far. At a leaf it takes, in float, a place q on each
// triangle that is about the nearest. Its distance is a bound from above whatever rounding did to
// q. A bound from below is how far the plane through q, at right angles to the way there, is in
// front of all three corners: equal to the distance if q is nearest, less if it isn't, never more
// than that of the triangle. What may still be nearest is collected and decided by the caller, in
// double. Explained in docs/algorithms/closest_point.md.
#pragma once

#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

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

/// The square of the distance of a point to the boxes of a node; infinite where there is none.
template <class S>
BOXWOOD_KERNEL typename S::Float squared_distance(const WideNode<S::kWidth>& node,
                                                  const Vector<S>& point) {
    using Float = typename S::Float;
    const Float zero = S::broadcast(0);
    const auto outside = [&](int k, Float p) {
        return S::max(S::max(S::load(node.slabs[k].lo) - p, p - S::load(node.slabs[k].hi)), zero);
    };
    const Vector<S> way = {outside(0, point.x), outside(1, point.y), outside(2, point.z)};
    return dot(way, way);
}

/// What may be nearest, collected until there is no more room.
template <class S>
class NearTriangles {
public:
    BOXWOOD_KERNEL NearTriangles(const PointQuery& query, const CandidateVisitor& visitor)
        : margin_(query.margin), look_margin_(0x1p-20f * query.reach), visitor_(visitor) {
        shorten(query.farthest);
    }

    /// Nothing beyond this can be nearest.
    BOXWOOD_KERNEL const float& farthest() const { return farthest_; }
    BOXWOOD_KERNEL const float& farthest_squared() const { return farthest_squared_; }

    BOXWOOD_KERNEL void offer(const TriangleBlock<S::kWidth>& block, const Vector<S>& point) {
        const BlockCorners<S> from(block, point);
        if (maybe_within<S>(from, S::broadcast(look_squared_)) == 0) return;
        const DistanceBounds<S> bounds = distance_bounds<S>(from);
        unsigned mask = S::less_equal(bounds.least, S::broadcast(farthest_));
        if (mask == 0) return;
        const unsigned nearer = S::less(bounds.most, S::broadcast(nearest_));
        if (nearer != 0) {
            shorten(S::least(nearer, bounds.most));
            mask = S::less_equal(bounds.least, S::broadcast(farthest_));
        }
        if (size_ > kCapacity - S::kWidth) make_room();
        S::store_unaligned(triangles_ + size_, S::compress(mask, S::load(block.triangle)));
        S::store_unaligned(least_ + size_, S::compress(mask, bounds.least));
        size_ += __builtin_popcount(mask);
    }

    /// Has the rest decided.
    BOXWOOD_KERNEL void finish() {
        size_ = compact<S>(triangles_, least_, size_, farthest_);
        decide();
    }

private:
    static constexpr int kCapacity = 32;  ///< as many as a mask has bits

    BOXWOOD_KERNEL void shorten(float nearest) {
        nearest_ = nearest;
        farthest_ = nearest + margin_;
        const float look = farthest_ + look_margin_;
        look_squared_ = look * look * (1 + 0x1p-20f);
        farthest_squared_ = farthest_ * farthest_ * (1 + 0x1p-20f);
    }
    BOXWOOD_KERNEL void make_room() {
        size_ = compact<S>(triangles_, least_, size_, farthest_);
        if (size_ > kCapacity / 2) decide();
    }
    BOXWOOD_KERNEL void decide() {
        if (size_ == 0) return;
        const unsigned mask = size_ == 32 ? ~0u : (1u << size_) - 1;
        const float nearest = visitor_.visit(visitor_.context, triangles_, mask);
        if (nearest < nearest_) shorten(nearest);
        size_ = 0;
    }

    float margin_, look_margin_;
    const CandidateVisitor& visitor_;
    float nearest_, farthest_, farthest_squared_, look_squared_;
    int size_ = 0;
    alignas(64) std::uint32_t triangles_[kCapacity + kStackSlack];
    alignas(64) float least_[kCapacity + kStackSlack];
};

template <class S>
void walk_near_triangles(const WideTreeView& tree, const PointQuery& query,
                         const CandidateVisitor& visitor) noexcept {
    constexpr int N = S::kWidth;
    using Float = typename S::Float;
    const Vector<S> point = {S::broadcast(query.point[0]), S::broadcast(query.point[1]),
                             S::broadcast(query.point[2])};
    NearTriangles<S> found(query, visitor);
    alignas(64) std::uint32_t references[kStackSize + kStackSlack];
    alignas(64) float distances[kStackSize + kStackSlack];
    int size = 0;
    WideReference current = 0;
    for (;;) {
        if (!is_leaf(current)) {
            const WideNode<N>& node = tree.node<N>(current);
            const Float squared = squared_distance<S>(node, point);
            const unsigned near = S::less_equal(squared, S::broadcast(found.farthest_squared()));
            if (near != 0) {
                const float nearest = S::least(near, squared);
                const unsigned first = near & S::equal(squared, S::broadcast(nearest));
                const unsigned rest = near & ~(first & -first);
                S::store_unaligned(references + size, S::compress(rest, S::load(node.child)));
                S::store_unaligned(distances + size, S::compress(rest, squared));
                size += __builtin_popcount(rest);
                current = node.child[__builtin_ctz(first)];
                continue;
            }
        } else {
            found.offer(tree.block<N>(current), point);
        }
        if (size > 0 && distances[size - 1] > found.farthest_squared())
            size = compact<S>(references, distances, size, found.farthest_squared());
        if (size == 0) break;
        current = references[--size];
        if (size > 0) prefetch<N>(tree, references[size - 1]);
    }
    found.finish();
}

}  // namespace boxwood
