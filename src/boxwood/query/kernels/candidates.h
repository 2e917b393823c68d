// SPDX-License-Identifier: Apache-2.0
// Which triangles might a ray hit? For queries that decide in double precision: the walk of
// closest_hit.h, and at the leaves a test in float that leaves out only what the exact ray cannot
// hit on the exact triangle. What is left, one triangle in most leaves, is for the caller to test.
// Explained in docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

/// The lanes that may be hit by a ray that is, as the triangles are, less than `error` off in each
/// sheared coordinate. An edge function's sign is sure beyond margin, a bound on what these errors
/// and its own rounding make of it.
template <class S>
BOXWOOD_KERNEL unsigned candidates(const TriangleBlock<S::kWidth>& block, const RaySetup& ray,
                                   typename S::Float error) {
    using Float = typename S::Float;
    const ShearedCorner<S> a(block.corner[0], ray), b(block.corner[1], ray),
        c(block.corner[2], ray);
    const Float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    const auto size = [](const ShearedCorner<S>& p) {
        return S::max(p.x, -p.x) + S::max(p.y, -p.y);
    };
    const Float largest = S::max(S::max(size(a), size(b)), size(c));
    const Float margin = (S::broadcast(4) * error + S::broadcast(0x1p-21f) * largest) * largest +
                         S::broadcast(4) * error * error;
    return S::less_equal(-margin, S::min(S::min(u, v), w)) |
           S::less_equal(S::max(S::max(u, v), w), margin);
}

template <class S>
void walk_candidates(const WideTreeView& tree, const Rayf& ray, float extra_rounding,
                     const CandidateVisitor& visitor) noexcept {
    constexpr int N = S::kWidth;
    using Float = typename S::Float;
    if (!is_traceable<typename S::Quad>(ray)) return;
    RaySetup setup;
    setup.set<typename S::Quad>(ray, tree, extra_rounding);
    const NodeRay<S> node_ray(setup);
    const Float error = S::broadcast(setup.rounding);
    float farthest = ray.t_max;
    TriangleBlock<N> room;
    walk<S>(tree, setup, node_ray, farthest, [&](WideReference reference) {
        const TriangleBlock<N>& block = block_at<N>(tree, reference, room);
        const unsigned mask = candidates<S>(block, setup, error);
        if (mask != 0) farthest = visitor.visit(visitor.context, block.triangle, mask);
    });
}

}  // namespace boxwood
