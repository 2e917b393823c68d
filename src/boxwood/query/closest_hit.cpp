// SPDX-License-Identifier: Apache-2.0
// What does a ray hit first? The tree is walked front to back, and each triangle that is hit closer
// than all before shortens the ray. Explained in docs/algorithms/closest_hit.md.
#include "boxwood/query/closest_hit.h"

#include <algorithm>

#include "boxwood/query/mesh_ray.h"

namespace boxwood {

std::optional<Hit> closest_hit(MeshView mesh, const Tree& tree, const Ray& ray,
                               TraversalCounts* counts) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return std::nullopt;
    const MeshRay mesh_ray(mesh, ray);
    Hit closest;
    traverse(
        tree, ray,
        [&](std::uint32_t triangle, double t_max) {
            const auto hit = mesh_ray.intersect(triangle, t_max);
            if (hit && is_closer(*hit, closest)) closest = *hit;
            return std::min(t_max, closest.t);
        },
        counts);
    if (closest.triangle == TriangleId::kNone) return std::nullopt;
    return closest;
}

}  // namespace boxwood
