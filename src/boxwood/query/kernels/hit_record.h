// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/kernels/tree_blocks.h"
#include "boxwood/query/kernels/triangle_block.h"

namespace boxwood {

/// The closest hit so far, and what is worked out of it only once it is final.
template <class S>
struct ClosestHit {
    static constexpr int N = S::kWidth;

    float t;
    std::uint32_t triangle = Hitf::kNone;
    WideReference place = 0;  ///< of its block
    int lane = 0;
    alignas(4 * N) float v[N];
    alignas(4 * N) float w[N];
    alignas(4 * N) float determinant[N];

    /// Keeps the best of the lanes if it is closer: equal distances go to the lower triangle.
    /// Returns whether it was.
    BOXWOOD_KERNEL bool offer(const TriangleBlock<N>& candidates, WideReference reference,
                              const BlockHit<S>& hit) {
        const float least = S::least(hit.mask, hit.t);
        const int first = __builtin_ctz(hit.mask & S::equal(hit.t, S::broadcast(least)));
        if (least == t && candidates.triangle[first] >= triangle) return false;
        t = least;
        triangle = candidates.triangle[first];
        place = reference;
        lane = first;
        S::store(v, hit.v);
        S::store(w, hit.w);
        S::store(determinant, hit.determinant);
        return true;
    }

    BOXWOOD_KERNEL void write(const WideTreeView& tree, Hitf& result) const {
        if (triangle == Hitf::kNone) {
            result = {};
            return;
        }
        const BlockTriangle hit = triangle_at<N>(tree, place, static_cast<unsigned>(lane));
        // Adding 0 turns -0 into 0: which of them it is depends on who was the first of equals.
        result.t = t + 0;
        result.u = v[lane] / determinant[lane] + 0;
        result.v = w[lane] / determinant[lane] + 0;
        result.triangle = triangle;
        result.instance = 0;
        normal_of(hit, result.normal);
    }
};

}  // namespace boxwood
