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

template <class S>
struct NodeRay {
    using Float = typename S::Float;

    Float inverse[3];   ///< of the direction
    Float near_term[3];  ///< a near face at p is reached at p * inverse + near_term
    Float far_term[3];
    Float t_min;
    bool negative[3];
    int octant;

    /// The bounds contain every box that will be asked for. Precondition: is_traceable(ray).
    BOXWOOD_KERNEL NodeRay(const Rayf& ray, const float (&lo)[3], const float (&hi)[3]) {
        const auto larger = [](float a, float b) { return a < b ? b : a; };
        float reach = 0, size = 0, length = 0;
        for (int k = 0; k < 3; ++k) {
            reach = larger(reach, larger(__builtin_fabsf(lo[k] - ray.origin[k]),
                                         __builtin_fabsf(hi[k] - ray.origin[k])));
            size = larger(size, __builtin_fabsf(ray.origin[k]));
            length = larger(length, __builtin_fabsf(ray.direction[k]));
        }
        const float rounding = 0x1p-19f * (reach + size);
        // A zero coordinate of the direction would make 0 * infinity; one so small that it moves
        // the ray by less than the rounding does not.
        const float tiny = 0x1p-40f * length;
        octant = 0;
        for (int k = 0; k < 3; ++k) {
            const float d = ray.direction[k];
            negative[k] = __builtin_signbit(d);
            octant |= negative[k] << k;
            const float i =
                1 / (__builtin_fabsf(d) < tiny ? __builtin_copysignf(tiny, d) : d);
            const float outward = __builtin_copysignf(rounding, d);
            inverse[k] = S::broadcast(i);
            near_term[k] = S::broadcast(-(ray.origin[k] + outward) * i);
            far_term[k] = S::broadcast(-(ray.origin[k] - outward) * i);
        }
        t_min = S::broadcast(ray.t_min);
    }

    /// Where the ray enters and leaves the children's boxes, within [t_min, t_max]; it misses those
    /// that it would leave before it enters.
    BOXWOOD_KERNEL void intersect(const WideNode<S::kWidth>& node, Float t_max, Float& enter,
                                  Float& leave) const {
        Float to_near[3], to_far[3];
        for (int k = 0; k < 3; ++k) {
            const auto& slab = node.slabs[k];
            const float* lo = slab.lo;
            const float* near = negative[k] ? lo + S::kWidth : lo;
            const float* far = negative[k] ? lo : lo + S::kWidth;
            to_near[k] = S::multiply_add(S::load(near), inverse[k], near_term[k]);
            to_far[k] = S::multiply_add(S::load(far), inverse[k], far_term[k]);
        }
        enter = S::max(S::max(to_near[0], to_near[1]), S::max(to_near[2], t_min));
        leave = S::min(S::min(to_far[0], to_far[1]), S::min(to_far[2], t_max));
    }
};

}  // namespace boxwood
