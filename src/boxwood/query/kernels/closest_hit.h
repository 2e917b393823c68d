// SPDX-License-Identifier: Apache-2.0
// What does one ray hit first? The walk of query/traverse.h on a wide tree: test the N children of
// a node at once, go on with the nearest, keep the others for later. The order of the children is
// not sorted for but read from the node: it has one for each octant of directions. When a child
// that was kept turns out to lie behind the closest hit, all those are thrown out together.
// Explained in docs/algorithms/wide_tree.md. Sources: Fuetterling et al., "Accelerated Single Ray
// Tracing for Wide Vector Units", HPG 2017; Wald et al., "Getting Rid of Packets", RT 2008.
#pragma once

#include "boxwood/query/kernels/node_ray.h"
#include "boxwood/query/kernels/triangle_block.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// The closest hit so far, and what is worked out of it only once it is final.
template <class S>
struct ClosestHit {
    static constexpr int N = S::kWidth;

    float t;
    std::uint32_t triangle = Hitf::kNone;
    const TriangleBlock<N>* block = nullptr;
    int lane = 0;
    alignas(4 * N) float v[N];
    alignas(4 * N) float w[N];
    alignas(4 * N) float determinant[N];

    /// Keeps the best of the lanes if it is closer: equal distances go to the lower triangle.
    /// Returns whether it was.
    BOXWOOD_KERNEL bool offer(const TriangleBlock<N>& candidates, const BlockHit<S>& hit) {
        const float least = S::least(hit.mask, hit.t);
        const int first =
            __builtin_ctz(hit.mask & S::equal(hit.t, S::broadcast(least)));
        if (least == t && candidates.triangle[first] >= triangle) return false;
        t = least;
        triangle = candidates.triangle[first];
        block = &candidates;
        lane = first;
        S::store(v, hit.v);
        S::store(w, hit.w);
        S::store(determinant, hit.determinant);
        return true;
    }

    BOXWOOD_KERNEL void write(Hitf& result) const {
        if (triangle == Hitf::kNone) {
            result = {};
            return;
        }
        const auto corner = [&](int i, int k) { return block->corner[i][k][lane]; };
        float ab[3], ac[3];
        for (int k = 0; k < 3; ++k) {
            ab[k] = corner(1, k) - corner(0, k);
            ac[k] = corner(2, k) - corner(0, k);
        }
        // Adding 0 turns -0 into 0: which of them it is depends on who was the first of equals.
        result.t = t + 0;
        result.u = v[lane] / determinant[lane] + 0;
        result.v = w[lane] / determinant[lane] + 0;
        result.triangle = triangle;
        for (int k = 0; k < 3; ++k) {
            const int i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
            result.normal[k] = ab[i] * ac[j] - ab[j] * ac[i];
        }
    }
};

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

template <class S>
void closest_hit(const WideTreeView& tree, const Rayf& ray, Hitf& result) noexcept {
    constexpr int N = S::kWidth;
    using Float = typename S::Float;
    ClosestHit<S> closest;
    closest.t = ray.t_max;
    if (!is_traceable(ray)) return closest.write(result);

    const NodeRay<S> node_ray(ray, tree.lo, tree.hi);
    const BlockRay<S> block_ray(ray);
    alignas(64) std::uint32_t references[kStackSize + kStackSlack];
    alignas(64) float distances[kStackSize + kStackSlack];
    int size = 0;
    Float t_max = S::broadcast(closest.t);
    WideReference current = 0;
    for (;;) {
        if (!is_leaf(current)) {
            const WideNode<N>& node = tree.node<N>(current);
            Float enter, leave;
            node_ray.intersect(node, t_max, enter, leave);
            const unsigned hit = S::less_equal(enter, leave);
            if (hit != 0) {
                if ((hit & (hit - 1)) == 0) {
                    current = node.child[__builtin_ctz(hit)];
                    continue;
                }
                const auto order = S::order(node.order, node_ray.octant);
                const Float ordered_enter = S::permute(enter, order);
                const unsigned ordered =
                    S::less_equal(ordered_enter, S::permute(leave, order));
                const auto child = S::permute(S::load(node.child), order);
                S::store_unaligned(references + size, S::compress(ordered, child));
                S::store_unaligned(distances + size, S::compress(ordered, ordered_enter));
                size += __builtin_popcount(hit) - 1;
                current = references[size];
                continue;
            }
        } else {
            const TriangleBlock<N>& block = tree.block<N>(current);
            const BlockHit<S> hit = intersect<S>(block, block_ray, t_max);
            if (hit.mask != 0 && closest.offer(block, hit)) t_max = S::broadcast(closest.t);
        }
        if (size == 0) break;
        if (distances[size - 1] > closest.t) {
            size = compact<S>(references, distances, size, closest.t);
            if (size == 0) break;
        }
        current = references[--size];
    }
    closest.write(result);
}

}  // namespace boxwood
