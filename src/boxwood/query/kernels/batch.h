// SPDX-License-Identifier: Apache-2.0
// Which kernel serves a batch of rays.
#pragma once

#include "boxwood/query/kernels/any_hit.h"
#include "boxwood/query/kernels/candidates.h"
#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/closest_point.h"
#include "boxwood/query/kernels/frustum_candidates.h"
#include "boxwood/query/kernels/frustum_hits.h"
#include "boxwood/query/kernels/overlaps.h"
#include "boxwood/query/kernels/wavefront.h"
#include "boxwood/query/kernels/wavefront_candidates.h"
#include "boxwood/query/kernels/wavefront_hits.h"
#include "boxwood/query/put_hit.h"

namespace boxwood {

/// Where groups take too many steps, triangles are smaller than the distance of their rays, or
/// these are no tiles. If the neighbours of one are like it, more and more of them go ray by ray,
/// up to so many.
constexpr std::size_t kMostPasses = 15;

/// Rays that have no more in common than that they are asked for together; rays and hits may be
/// arrays or columns.
template <class S, class Rays, class Hits>
BOXWOOD_KERNEL void closest_hits_of_any(const WideTreeView& tree, const Rays& rays,
                                        const Hits& hits, std::size_t count) {
    if (count < kFewRays || tree.stack_size > kWavefrontStack) {
        for (std::size_t i = 0; i < count; ++i) {
            Hitf hit = {};
            closest_hit<S>(tree, rays[i], hit);
            put_hit(hits, i, hit);
        }
    } else {
        Wavefront<S, ClosestHitsOfRays<S, Rays, Hits>>(tree, {tree, rays, hits}, count).run();
    }
}

template <class S, class Rays>
BOXWOOD_KERNEL void any_hits_of_any(const WideTreeView& tree, const Rays& rays, bool* hits,
                                    std::size_t count) {
    if (count < kFewRays || tree.stack_size > kWavefrontStack) {
        for (std::size_t i = 0; i < count; ++i) hits[i] = any_hit<S>(tree, rays[i]);
    } else {
        Wavefront<S, AnyHitsOfRays<S, Rays>>(tree, {tree, rays, hits}, count).run();
    }
}

/// Whether rays may well be a group: those at both ends start at one point.
BOXWOOD_KERNEL bool share_origin(const Rayf& a, const Rayf& b) {
    return (a.origin[0] == b.origin[0]) & (a.origin[1] == b.origin[1]) &
           (a.origin[2] == b.origin[2]);
}

/// Asks for what a group will be read from next and be written to. Bit by bit, between
/// computations, as a processor waits for few places in memory at a time.
template <class Answer>
struct GroupFetch {
    const Rayf* next_rays;
    const Answer* answers;

    BOXWOOD_KERNEL void operator()(std::size_t first, std::size_t count) const {
        ask_for(next_rays + first, count);
        ask_for(answers + first, count);
    }

private:
    template <class T>
    BOXWOOD_KERNEL static void ask_for(const T* place, std::size_t count) {
        for (std::size_t i = 0; i < count; i += 64 / sizeof(T)) __builtin_prefetch(place + i, 0, 2);
    }
};

/// Groups of rays that start at one point go by frusta, all others in runs by others(begin, end).
/// are_plain(begin, end) says whether such rays may go by a frustum.
template <class S, class Rule, class Answer, class ArePlain, class Others>
BOXWOOD_KERNEL void answer_by_groups(const WideTreeView& tree, const Rayf* rays, Answer* answers,
                                     std::size_t count, const ArePlain& are_plain,
                                     const Others& others) {
    constexpr std::size_t kGroup = Frustum<S, Rule>::kRays;
    Frustum<S, Rule> frustum(tree);
    constexpr std::size_t kStepsAlone = Frustum<S, Rule>::kStepsAlone;
    std::size_t saved = 0;   // steps that groups before took less, so that this one may take more
    std::size_t begin = 0;   // of the rays that were passed over
    std::size_t passes = 0;  // groups to pass over before the next try ...
    std::size_t dense = 0;   // ... and after it, should it be dense
    for (std::size_t i = 0; i + kGroup <= count; i += kGroup) {
        if (passes > 0) {
            --passes;
            continue;
        }
        if (tree.bytes > Frustum<S, Rule>::kLargestTree ||
            !share_origin(rays[i], rays[i + kGroup - 1]) || !are_plain(i, i + kGroup))
            continue;
        const Rayf* next_rays = i + 2 * kGroup <= count ? rays + i + kGroup : rays + i;
        if (!frustum.load(rays + i, GroupFetch<Answer>{next_rays, answers + i})) continue;
        if (!frustum.run(kStepsAlone + saved)) {
            saved = 0;
            passes = dense = dense < kMostPasses ? 2 * dense + 1 : dense;
            continue;
        }
        saved += kStepsAlone;
        saved = frustum.steps() < saved ? saved - frustum.steps() : 0;
        if (saved > 2 * kStepsAlone) saved = 2 * kStepsAlone;
        dense = 0;
        others(begin, i);
        frustum.write(answers + i);
        begin = i + kGroup;
    }
    others(begin, count);
}

template <class S>
void closest_hits(const WideTreeView& tree, const Rayf* rays, Hitf* hits,
                  std::size_t count) noexcept {
    const auto others = [&](std::size_t begin, std::size_t end) {
        closest_hits_of_any<S>(tree, rays + begin, hits + begin, end - begin);
    };
    const auto all_are_plain = [](std::size_t, std::size_t) { return true; };
    answer_by_groups<S, FrustumHits<S>>(tree, rays, hits, count, all_are_plain, others);
}

template <class S>
void any_hits(const WideTreeView& tree, const Rayf* rays, bool* hits, std::size_t count) noexcept {
    any_hits_of_any<S>(tree, rays, hits, count);
}

template <class S>
void closest_hits_in_columns(const WideTreeView& tree, const RayColumns& rays,
                             const HitColumns& hits) noexcept {
    closest_hits_of_any<S>(tree, rays, hits, rays.count);
}

template <class S>
void any_hits_in_columns(const WideTreeView& tree, const RayColumns& rays, bool* hits) noexcept {
    any_hits_of_any<S>(tree, rays, hits, rays.count);
}

template <class S>
void closest_candidates(const WideTreeView& tree, const CandidateRays& rays, Candidates* candidates,
                        std::size_t count) noexcept {
    const auto others = [&](std::size_t begin, std::size_t end) {
        const CandidatesOfRays<S, false> query = {tree, rays.from(begin), candidates + begin};
        if (begin < end) Wavefront<S, CandidatesOfRays<S, false>>(tree, query, end - begin).run();
    };
    // Frusta know of no other rounding than that to float, and skip nothing.
    const auto are_plain = [&](std::size_t begin, std::size_t end) {
        bool is_plain = true;
        for (std::size_t i = begin; i < end; ++i)
            is_plain &= (rays.extra_rounding[i] == 0) & (rays.skip[i] == Hitf::kNone);
        return is_plain;
    };
    answer_by_groups<S, FrustumCandidates<S>>(tree, rays.ray, candidates, count, are_plain, others);
}

template <class S>
void any_candidates(const WideTreeView& tree, const CandidateRays& rays, Candidates* candidates,
                    std::size_t count) noexcept {
    const CandidatesOfRays<S, true> query = {tree, rays, candidates};
    Wavefront<S, CandidatesOfRays<S, true>>(tree, query, count).run();
}

}  // namespace boxwood
