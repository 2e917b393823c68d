// SPDX-License-Identifier: Apache-2.0
// What a wavefront asks of rays in double: which triangles have to be tested in double to know what
// is hit. Where float is sure that a triangle is hit, the ray ends there at the latest, so that
// mostly one is left. Explained in docs/algorithms/certified_hits.md.
#pragma once

#include "boxwood/query/kernels/candidates.h"

namespace boxwood {

/// The candidates of a ray so far, and from where to where float is sure that it sees.
template <class S>
struct CandidatesSoFar {
    static constexpr int N = S::kWidth;

    float t;                   ///< what is hit is no farther
    float error;               ///< as in CandidateTest
    float sure_min, sure_max;  ///< what is surely in between lies in [t_min, t_max]
    std::uint32_t skip;
    std::uint32_t count;
    std::uint32_t triangle[Candidates::kMost + N];
    float nearest[Candidates::kMost + N];

    BOXWOOD_KERNEL void start(const Rayf& ray, float ray_error, std::uint32_t skipped) {
        t = ray.t_max;
        error = ray_error;
        sure_min = surely_beyond(ray.t_min, error);
        sure_max = surely_before(ray.t_max, error);
        skip = skipped;
        count = 0;
    }

    /// False when there are too many.
    BOXWOOD_KERNEL bool add(const TriangleBlock<N>& block, unsigned mask,
                            const CandidateTest<S>& test) {
        if (count + static_cast<unsigned>(__builtin_popcount(mask)) > Candidates::kMost) {
            drop_hidden();
            if (count + static_cast<unsigned>(__builtin_popcount(mask)) > Candidates::kMost) {
                count = Candidates::kTooMany;
                return false;
            }
        }
        S::store_unaligned(triangle + count, S::compress(mask, S::load(block.triangle)));
        S::store_unaligned(nearest + count, S::compress(mask, test.nearest()));
        count += static_cast<unsigned>(__builtin_popcount(mask));
        return true;
    }

    /// Drops those that lie behind what is hit for sure.
    BOXWOOD_KERNEL void drop_hidden() {
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            triangle[kept] = triangle[i];
            nearest[kept] = nearest[i];
            kept += nearest[i] <= t;
        }
        count = kept;
    }

    BOXWOOD_KERNEL void write(Candidates& candidates) const {
        candidates.count = count;
        __builtin_memcpy(candidates.triangle, triangle, sizeof candidates.triangle);
    }
};

/// What may be the closest hit of each ray, or, with kAnyHit, any hit.
template <class S, bool kAnyHit>
struct CandidatesOfRays {
    using State = CandidatesSoFar<S>;
    static constexpr bool kNearestFirst = !kAnyHit;

    const WideTreeView& tree;
    CandidateRays rays;
    Candidates* candidates;

    BOXWOOD_KERNEL bool start(std::size_t i, RaySetup& setup, State& state) const {
        const Rayf& ray = rays.ray[i];
        if (!is_traceable<typename S::Quad>(ray)) {
            candidates[i].count = 0;
            return false;
        }
        setup.set<typename S::Quad>(ray, tree, rays.extra_rounding[i]);
        state.start(ray, candidate_error(setup, rays.extra_rounding[i]), rays.skip[i]);
        return true;
    }

    BOXWOOD_KERNEL bool visit(const TriangleBlock<S::kWidth>& block, WideReference,
                              const RaySetup& setup, State& state) const {
        const CandidateTest<S> test(block, setup, state.error);
        unsigned mask = test.may_be_hit(setup.t_min, S::broadcast(state.t));
        if (mask == 0) return false;
        mask = test.not_before(setup.t_min, mask);
        if (mask == 0) return false;
        mask &= ~S::equal(S::load(block.triangle), S::broadcast_integer(state.skip));
        const unsigned sure =
            mask & test.is_hit() & S::less_equal(S::broadcast(state.sure_min), test.nearest());
        if (kAnyHit && (sure & S::less_equal(test.farthest(), S::broadcast(state.sure_max))) != 0) {
            state.count = Candidates::kSureHit;
            return true;
        }
        if (!kAnyHit && sure != 0) {
            const float t = S::least(sure, test.no_farther());
            state.t = t < state.t ? t : state.t;
        }
        return !state.add(block, mask, test);
    }

    BOXWOOD_KERNEL void finish(std::size_t i, State& state) const {
        if (!kAnyHit && state.count <= Candidates::kMost) state.drop_hidden();
        state.write(candidates[i]);
    }
};

}  // namespace boxwood
