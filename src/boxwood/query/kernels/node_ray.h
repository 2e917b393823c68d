// SPDX-License-Identifier: Apache-2.0
// Which of the N children of a node does a ray hit? The slab test of core/ray_box.h in float, N
// boxes at a time. The origin is moved outward by a bound on every rounding error, here and in the
// triangle test, so that no box is missed when a triangle in it is hit: whatever the instruction
// set rounds, the answers stay the same. Explained in docs/algorithms/ray_box.md.
#pragma once

#include "boxwood/query/kernels/ray_setup.h"

namespace boxwood {

/// A ray in every lane, for nodes.
template <class S>
struct NodeRay {
    using Float = typename S::Float;
    static constexpr int N = S::kWidth;

    Float inverse[3], near_term[3], far_term[3], t_min;
    std::size_t near_faces[3], far_faces[3];

    explicit BOXWOOD_KERNEL NodeRay(const RaySetup& ray) {
        for (int k = 0; k < 3; ++k) {
            inverse[k] = S::broadcast(ray.inverse[k]);
            near_term[k] = S::broadcast(ray.near_term[k]);
            far_term[k] = S::broadcast(ray.far_term[k]);
            near_faces[k] = ray.near_faces<N>(k);
            far_faces[k] = ray.far_faces<N>(k);
        }
        t_min = S::broadcast(ray.t_min);
    }

    /// Where the ray enters and leaves the children's boxes, within [t_min, t_max]; it misses those
    /// that it would leave before it enters.
    BOXWOOD_KERNEL void intersect(const WideNode<N>& node, Float t_max, Float& enter,
                                  Float& leave) const {
        const float* faces = &node.slabs[0].lo[0];
        Float to_near[3], to_far[3];
        for (int k = 0; k < 3; ++k) {
            to_near[k] = S::multiply_add(S::load(faces + near_faces[k]), inverse[k], near_term[k]);
            to_far[k] = S::multiply_add(S::load(faces + far_faces[k]), inverse[k], far_term[k]);
        }
        enter = S::max(S::max(to_near[0], to_near[1]), S::max(to_near[2], t_min));
        leave = S::min(S::min(to_far[0], to_far[1]), S::min(to_far[2], t_max));
    }
};

}  // namespace boxwood
