// SPDX-License-Identifier: Apache-2.0
// Which triangles might be nearest to a point? The walk goes to the nearest box first and leaves
// out boxes beyond the nearest triangle so far. At a leaf it takes bounds on the distance of each
// triangle. What may still be nearest is collected and decided by the caller, in double.
// Explained in docs/algorithms/closest_point.md.
#pragma once

#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/distance_bounds.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

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
        : margin_(query.margin),
          spread_(query.spread),
          look_margin_(0x1p-20f * query.reach),
          visitor_(visitor) {
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
        const auto most = bounds.most * S::broadcast(spread_);
        const unsigned nearer = S::less(most, S::broadcast(nearest_));
        if (nearer != 0) {
            shorten(S::least(nearer, most));
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

    float margin_, spread_, look_margin_;
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
    TriangleBlock<N> room;
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
            found.offer(block_at<N>(tree, current, room), point);
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
