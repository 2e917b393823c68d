// SPDX-License-Identifier: Apache-2.0
// Which triangles might touch a box? Those in leaves that the box touches whose own box does.
// Explained in docs/algorithms/overlaps.md.
#pragma once

#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// A box in every lane.
template <class S>
struct LaneBox {
    using Float = typename S::Float;

    Float lo[3], hi[3];

    explicit BOXWOOD_KERNEL LaneBox(const BoxQuery& box) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = S::broadcast(box.lo[k]);
            hi[k] = S::broadcast(box.hi[k]);
        }
    }

    /// The lanes that lie between both along an axis, touching included.
    BOXWOOD_KERNEL unsigned touches(int k, Float from, Float to) const {
        return S::less_equal(from, hi[k]) & S::less_equal(lo[k], to);
    }
};

template <class S>
void walk_overlaps(const WideTreeView& tree, const BoxQuery& query,
                   const CandidateVisitor& visitor) noexcept {
    constexpr int N = S::kWidth;
    const LaneBox<S> box(query);
    alignas(64) std::uint32_t references[kStackSize + kStackSlack];
    references[0] = 0;
    TriangleBlock<N> room;
    int size = 1;
    while (size > 0) {
        const WideReference current = references[--size];
        unsigned mask = ~0u;
        if (is_leaf(current)) {
            const TriangleBlock<N>& block = block_at<N>(tree, current, room);
            for (int k = 0; k < 3; ++k) {
                const auto a = S::load(block.corner[0][k]), b = S::load(block.corner[1][k]),
                           c = S::load(block.corner[2][k]);
                mask &= box.touches(k, S::min(S::min(a, b), c), S::max(S::max(a, b), c));
            }
            if (mask != 0 && visitor.visit(visitor.context, block.triangle, mask) < 0) return;
        } else {
            const WideNode<N>& node = tree.node<N>(current);
            for (int k = 0; k < 3; ++k)
                mask &= box.touches(k, S::load(node.slabs[k].lo), S::load(node.slabs[k].hi));
            S::store_unaligned(references + size, S::compress(mask, S::load(node.child)));
            size += __builtin_popcount(mask);
        }
    }
}

}  // namespace boxwood
