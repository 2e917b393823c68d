// SPDX-License-Identifier: Apache-2.0
// Does one ray hit anything? No order and no distances are kept: the largest of the children that
// are hit goes first, since a hit is likeliest there. Explained in docs/algorithms/any_hit.md.
#pragma once

#include "boxwood/query/kernels/counting.h"
#include "boxwood/query/kernels/node_ray.h"
#include "boxwood/query/kernels/tree_blocks.h"
#include "boxwood/query/kernels/triangle_block.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

template <class S, class... Counts>
bool any_hit(const WideTreeView& tree, const Rayf& ray, Counts&... counts) noexcept {
    constexpr int N = S::kWidth;
    using Float = typename S::Float;
    if (!is_traceable<typename S::Quad>(ray)) return false;

    RaySetup setup;
    setup.set<typename S::Quad>(ray, tree);
    const NodeRay<S> node_ray(setup);
    const Float t_max = S::broadcast(ray.t_max);
    alignas(64) std::uint32_t references[kStackSize + kStackSlack];
    TriangleBlock<N> room;
    int size = 0;
    WideReference current = 0;
    for (;;) {
        if (!is_leaf(current)) {
            const WideNode<N>& node = tree.node<N>(current);
            Float enter, leave;
            node_ray.intersect(node, t_max, enter, leave);
            const unsigned hit = S::less_equal(enter, leave);
            count_node(node, hit != 0, false, counts...);
            if (hit != 0) {
                // Children stand in the order of their area, the largest last.
                const int largest = 31 - __builtin_clz(hit);
                current = node.child[largest];
                if ((hit & (hit - 1)) != 0) {
                    S::store_unaligned(references + size, S::compress(hit, S::load(node.child)));
                    size += __builtin_popcount(hit) - 1;
                }
                continue;
            }
        } else {
            count_block<N>(tree, current, false, counts...);
            if (intersect<S>(block_at<N>(tree, current, room), setup, t_max).mask != 0) return true;
        }
        if (size == 0) return false;
        current = references[--size];
    }
}

}  // namespace boxwood
