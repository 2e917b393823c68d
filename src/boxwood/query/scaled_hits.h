// SPDX-License-Identifier: Apache-2.0
// A tree whose mesh is too large or too small for float arithmetic holds it scaled by a power of
// two: rays go there, and hits come back.
#pragma once

#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

inline Rayf scaled(Rayf ray, float scale) {
    for (float& coordinate : ray.origin) coordinate *= scale;
    ray.t_min *= scale;
    ray.t_max *= scale;
    return ray;
}

/// The closest hit, its normal in the scale of the tree: in that of the mesh it may not fit floats.
inline Hitf hit_on_scaled(const WideTree& tree, const Rayf& ray) {
    Hitf hit;
    if (tree.is_empty()) return hit;
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    kernels.closest_hit(tree.view(), scaled(ray, tree.scale()), hit);
    hit.t *= 1 / tree.scale();
    return hit;
}

}  // namespace boxwood
