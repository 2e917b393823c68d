// SPDX-License-Identifier: Apache-2.0
// What a wavefront asks of rays in float: the closest hit, or whether there is any.
#pragma once

#include "boxwood/query/kernels/hit_record.h"
#include "boxwood/query/put_hit.h"

namespace boxwood {

/// Rays and hits are arrays or columns of them.
template <class S, class Rays, class Hits>
struct ClosestHitsOfRays {
    using State = ClosestHit<S>;
    static constexpr bool kNearestFirst = true;

    const WideTreeView& tree;
    Rays rays;
    Hits hits;

    BOXWOOD_KERNEL bool start(std::size_t i, RaySetup& setup, State& closest) const {
        const Rayf& ray = rays[i];
        if (!is_traceable<typename S::Quad>(ray)) {
            put_hit(hits, i, {});
            return false;
        }
        fetch_place(hits, i);
        setup.set<typename S::Quad>(ray, tree);
        closest.t = ray.t_max;
        closest.triangle = Hitf::kNone;
        return true;
    }

    BOXWOOD_KERNEL bool visit(const TriangleBlock<S::kWidth>& block, WideReference reference,
                              const RaySetup& setup, State& closest) const {
        const BlockHit<S> hit = intersect<S>(block, setup, S::broadcast(closest.t));
        if (hit.mask != 0) closest.offer(block, reference, hit);
        return false;
    }

    BOXWOOD_KERNEL void finish(std::size_t i, const State& closest) const {
        Hitf hit;
        closest.write(tree, hit);
        put_hit(hits, i, hit);
    }
};

template <class S, class Rays>
struct AnyHitsOfRays {
    struct State {
        float t;
        bool is_hit;
    };
    static constexpr bool kNearestFirst = false;

    const WideTreeView& tree;
    Rays rays;
    bool* hits;

    BOXWOOD_KERNEL bool start(std::size_t i, RaySetup& setup, State& state) const {
        const Rayf& ray = rays[i];
        if (!is_traceable<typename S::Quad>(ray)) {
            hits[i] = false;
            return false;
        }
        setup.set<typename S::Quad>(ray, tree);
        state = {ray.t_max, false};
        return true;
    }

    BOXWOOD_KERNEL bool visit(const TriangleBlock<S::kWidth>& block, WideReference,
                              const RaySetup& setup, State& state) const {
        state.is_hit = intersect<S>(block, setup, S::broadcast(state.t)).mask != 0;
        return state.is_hit;
    }

    BOXWOOD_KERNEL void finish(std::size_t i, const State& state) const { hits[i] = state.is_hit; }
};

}  // namespace boxwood
