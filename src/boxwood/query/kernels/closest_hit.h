// SPDX-License-Identifier: Apache-2.0
// What does one ray hit first? The walk of query/traverse.h on a wide tree: test the N children of
// a node at once, go on with the nearest, keep the others for later. The order of the children is
// not sorted for but read from the node: it has one for each octant of directions. When a child
// that was kept turns out to lie behind the closest hit, all those are thrown out together.
// Explained in docs/algorithms/wide_tree.md. Sources: Fuetterling et al., "Accelerated Single Ray
// Tracing for Wide Vector Units", HPG 2017; Wald et al., "Getting Rid of Packets", RT 2008.
#pragma once

#include "boxwood/query/kernels/counting.h"
#include "boxwood/query/kernels/hit_record.h"
#include "boxwood/query/kernels/node_ray.h"
#include "boxwood/query/kernels/triangle_block.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// Moves what a ray still has to visit together: the places with distances up to t_max. Returns
/// their number.
template <class S>
BOXWOOD_KERNEL int compact(std::uint32_t* references, float* distances, int size, float t_max) {
    using Float = typename S::Float;
    int kept = 0;
    for (int i = 0; i < size; i += S::kWidth) {
        const Float distance = S::load_unaligned(distances + i);
        unsigned mask = S::less_equal(distance, S::broadcast(t_max));
        if (size - i < S::kWidth) mask &= (1u << (size - i)) - 1;
        const auto reference = S::load_unaligned(references + i);
        S::store_unaligned(distances + kept, S::compress(mask, distance));
        S::store_unaligned(references + kept, S::compress(mask, reference));
        kept += __builtin_popcount(mask);
    }
    return kept;
}

/// Visits the blocks that the ray meets before t_max, nearest first. A visit may lower t_max.
template <class S, class Visit, class... Counts>
BOXWOOD_KERNEL void walk(const WideTreeView& tree, const RaySetup& setup,
                         const NodeRay<S>& node_ray, const float& t_max, const Visit& visit,
                         Counts&... counts) {
    constexpr int N = S::kWidth;
    using Float = typename S::Float;
    alignas(64) std::uint32_t references[kStackSize + kStackSlack];
    alignas(64) float distances[kStackSize + kStackSlack];
    int size = 0;
    WideReference current = 0;
    for (;;) {
        if (!is_leaf(current)) {
            const WideNode<N>& node = tree.node<N>(current);
            Float enter, leave;
            node_ray.intersect(node, S::broadcast(t_max), enter, leave);
            const unsigned hit = S::less_equal(enter, leave);
            count_node(node, hit != 0, (hit & (hit - 1)) != 0, counts...);
            if (hit != 0) {
                if ((hit & (hit - 1)) == 0) {
                    current = node.child[__builtin_ctz(hit)];
                    continue;
                }
                const auto order = S::order(node.order, static_cast<int>(setup.octant));
                const Float ordered_enter = S::permute(enter, order);
                const unsigned ordered = S::less_equal(ordered_enter, S::permute(leave, order));
                const auto child = S::permute(S::load(node.child), order);
                S::store_unaligned(references + size, S::compress(ordered, child));
                S::store_unaligned(distances + size, S::compress(ordered, ordered_enter));
                size += __builtin_popcount(hit) - 1;
                current = references[size];
                continue;
            }
        } else {
            visit(current);
        }
        if (size == 0) return;
        if (distances[size - 1] > t_max) {
            size = compact<S>(references, distances, size, t_max);
            if (size == 0) return;
        }
        current = references[--size];
    }
}

template <class S, class... Counts>
void closest_hit(const WideTreeView& tree, const Rayf& ray, Hitf& result,
                 Counts&... counts) noexcept {
    ClosestHit<S> closest;
    closest.t = ray.t_max;
    if (is_traceable<typename S::Quad>(ray)) {
        RaySetup setup;
        setup.set<typename S::Quad>(ray, tree);
        const NodeRay<S> node_ray(setup);
        TriangleBlock<S::kWidth> room;
        const auto visit = [&](WideReference reference) {
            const auto& block = block_at<S::kWidth>(tree, reference, room);
            const BlockHit<S> hit = intersect<S>(block, setup, S::broadcast(closest.t));
            count_block<S::kWidth>(tree, reference, hit.mask != 0, counts...);
            if (hit.mask != 0) closest.offer(block, reference, hit);
        };
        walk<S>(tree, setup, node_ray, closest.t, visit, counts...);
    }
    closest.write(tree, result);
}

}  // namespace boxwood
