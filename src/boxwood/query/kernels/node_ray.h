// SPDX-License-Identifier: Apache-2.0
// Which of the N children of a node does a ray hit? The slab test of core/ray_box.h in float, N
// boxes at a time. The origin is moved outward by a bound on every rounding error, here and in the
// triangle test, so that no box is missed when a triangle in it is hit: whatever the instruction
// set rounds, the answers stay the same. Explained in docs/algorithms/ray_box.md.
#pragma once

#include <array>

#include "boxwood/query/kernels/ray_setup.h"

namespace boxwood {

/// Where in a node of N children the faces are that a ray of an octant meets first and last along
/// each axis, in floats.
template <int N>
struct FacePlaces {
    std::size_t near_faces[3], far_faces[3];
};

template <int N>
constexpr std::array<FacePlaces<N>, 8> face_places() {
    std::array<FacePlaces<N>, 8> places{};
    for (std::size_t octant = 0; octant < 8; ++octant) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t is_negative = octant >> k & 1;
            places[octant].near_faces[k] = (2 * k + is_negative) * N;
            places[octant].far_faces[k] = (2 * k + 1 - is_negative) * N;
        }
    }
    return places;
}

/// Read from a table, as compilers gather what is worked out for a ray in vectors and take it
/// apart.
template <int N>
inline constexpr std::array<FacePlaces<N>, 8> kFacePlaces = face_places<N>();

/// A ray in every lane, for nodes.
template <class S>
struct NodeRay {
    using Float = typename S::Float;
    static constexpr int N = S::kWidth;

    Float inverse[3], near_term[3], far_term[3], t_min;
    const FacePlaces<N>& places;

    explicit BOXWOOD_KERNEL NodeRay(const RaySetup& ray) : places(kFacePlaces<N>[ray.octant]) {
        for (int k = 0; k < 3; ++k) {
            inverse[k] = S::broadcast(ray.inverse[k]);
            near_term[k] = S::broadcast(ray.near_term[k]);
            far_term[k] = S::broadcast(ray.far_term[k]);
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
                S::multiply_add(S::load(faces + places.near_faces[k]), inverse[k], near_term[k]);
            to_far[k] =
                S::multiply_add(S::load(faces + places.far_faces[k]), inverse[k], far_term[k]);
        }
        enter = S::max(S::max(to_near[0], to_near[1]), S::max(to_near[2], t_min));
        leave = S::min(S::min(to_far[0], to_far[1]), S::min(to_far[2], t_max));
    }
};

}  // namespace boxwood
