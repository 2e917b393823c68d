// SPDX-License-Identifier: Apache-2.0
// Which triangles might a ray hit? For queries that decide in double precision: the walk of
// closest_hit.h, and at the leaves a test in float that leaves out only what the exact ray cannot
// hit on the exact triangle. What is left, one triangle in most leaves, is for the caller to test.
// Explained in docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

/// The lanes that may be hit within [t_min, farthest] by a ray that is, as the triangles are, less
/// than `error` off in each sheared coordinate. An edge function's sign is sure beyond margin, a
/// bound on what these errors and its own rounding make of it.
template <class S>
BOXWOOD_KERNEL unsigned candidates(const TriangleBlock<S::kWidth>& block, const RaySetup& ray,
                                   float error, float farthest) {
    using Float = typename S::Float;
    const ShearedCorner<S> a(block.corner[0], ray), b(block.corner[1], ray),
        c(block.corner[2], ray);
    const Float u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    const auto size = [](const ShearedCorner<S>& p) {
        return S::max(p.x, -p.x) + S::max(p.y, -p.y);
    };
    const Float largest = S::max(S::max(size(a), size(b)), size(c));
    const Float margin = (S::broadcast(2 * error) + S::broadcast(0x1.2p-23f) * largest) * largest +
                         S::broadcast(2 * error * error);

    // A hit is as far as a mean of the corners is.
    const Float sz = S::broadcast(ray.sz), az = sz * a.z, bz = sz * b.z, cz = sz * c.z;
    const Float first = S::min(S::min(az, bz), cz), last = S::max(S::max(az, bz), cz);
    return (S::less_equal(-margin, S::min(S::min(u, v), w)) |
            S::less_equal(S::max(S::max(u, v), w), margin)) &
           S::less_equal(first, S::broadcast(farthest + 2 * error)) &
           S::less_equal(S::broadcast(ray.t_min - 2 * error), last);
}

template <class S>
void walk_candidates(const WideTreeView& tree, const Rayf& ray, float extra_rounding,
                     const CandidateVisitor& visitor) noexcept {
    constexpr int N = S::kWidth;
    if (!is_traceable<typename S::Quad>(ray)) return;
    RaySetup setup;
    setup.set<typename S::Quad>(ray, tree, extra_rounding);
    const NodeRay<S> node_ray(setup);
    // Half of the rounding that boxes need is more than that of sheared coordinates.
    const float error = 0.5f * setup.rounding + 1.5f * extra_rounding;
    float farthest = ray.t_max;
    TriangleBlock<N> room;
    walk<S>(tree, setup, node_ray, farthest, [&](WideReference reference) {
        const TriangleBlock<N>& block = block_at<N>(tree, reference, room);
        const unsigned mask = candidates<S>(block, setup, error, farthest);
        if (mask != 0) farthest = visitor.visit(visitor.context, block.triangle, mask);
    });
}

}  // namespace boxwood
