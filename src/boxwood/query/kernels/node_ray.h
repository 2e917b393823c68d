// SPDX-License-Identifier: Apache-2.0
// Which of the N children of a node does a ray hit? The slab test of core/ray_box.h in float, N
// boxes at a time. The origin is moved outward by a bound on every rounding error, here and in the
// triangle test, so that no box is missed when a triangle in it is hit: whatever the instruction
// set rounds, the answers stay the same. Explained in docs/algorithms/ray_box.md.
#pragma once

#include "boxwood/core/simd.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Of the first three lanes.
template <class Quad>
BOXWOOD_KERNEL float largest(typename Quad::Float x) {
    alignas(16) float lane[4];
    Quad::store(lane, x);
    const float xy = lane[0] > lane[1] ? lane[0] : lane[1];
    return xy > lane[2] ? xy : lane[2];
}

template <class S>
struct NodeRay {
    using Float = typename S::Float;
    static constexpr int N = S::kWidth;

    Float inverse[3];    ///< of the direction
    Float near_term[3];  ///< a near face at p is reached at p * inverse + near_term
    Float far_term[3];
    Float t_min;
    /// Where in a node the near faces along each axis are, and the far ones, in floats.
    std::size_t near_faces[3], far_faces[3];
    int octant;

    /// The bounds contain every box that will be asked for. Precondition: is_traceable(ray).
    BOXWOOD_KERNEL NodeRay(const Rayf& ray, const float (&lo)[4], const float (&hi)[4]) {
        using Quad = typename S::Quad;
        const auto origin = Quad::load_unaligned(ray.origin);
        const auto direction = Quad::load_unaligned(ray.direction);
        // A zero coordinate of the direction would make 0 * infinity; one so small that it moves
        // the ray by less than the rounding does not.
        const auto tiny = Quad::broadcast(0x1p-40f * largest<Quad>(Quad::abs(direction)));
        const auto clamped = Quad::copy_sign(Quad::max(Quad::abs(direction), tiny), direction);
        const auto inverse_direction = Quad::broadcast(1) / clamped;

        const auto to_lo = Quad::abs(Quad::load_unaligned(lo) - origin);
        const auto to_hi = Quad::abs(Quad::load_unaligned(hi) - origin);
        const float reach = largest<Quad>(Quad::max(to_lo, to_hi));
        const float rounding = 0x1p-19f * (reach + largest<Quad>(Quad::abs(origin)));
        const auto outward = Quad::copy_sign(Quad::broadcast(rounding), direction);
        alignas(16) float inverses[4], near_terms[4], far_terms[4];
        Quad::store(inverses, inverse_direction);
        Quad::store(near_terms, -((origin + outward) * inverse_direction));
        Quad::store(far_terms, -((origin - outward) * inverse_direction));

        octant = static_cast<int>(Quad::signs(direction) & 7);
        for (int k = 0; k < 3; ++k) {
            const std::size_t negative = octant >> k & 1;
            near_faces[k] = (2 * k + negative) * N;
            far_faces[k] = (2 * k + 1 - negative) * N;
            inverse[k] = S::broadcast(inverses[k]);
            near_term[k] = S::broadcast(near_terms[k]);
            far_term[k] = S::broadcast(far_terms[k]);
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
            to_near[k] =
                S::multiply_add(S::load(faces + near_faces[k]), inverse[k], near_term[k]);
            to_far[k] = S::multiply_add(S::load(faces + far_faces[k]), inverse[k], far_term[k]);
        }
        enter = S::max(S::max(to_near[0], to_near[1]), S::max(to_near[2], t_min));
        leave = S::min(S::min(to_far[0], to_far[1]), S::min(to_far[2], t_max));
    }
};

}  // namespace boxwood
