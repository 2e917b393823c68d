// SPDX-License-Identifier: Apache-2.0
// What does a ray hit first? The tree is walked front to back, and each triangle that is hit closer
// than all before shortens the ray. Explained in docs/algorithms/closest_hit.md.
#include "boxwood/query/closest_hit.h"

#include <algorithm>

#include "boxwood/query/brute_force.h"
#include "boxwood/query/mesh_ray.h"

namespace boxwood {

namespace {

/// The tree is walked along a ray of its own, the same but for being off by so much.
template <class Surface>
std::optional<Hit> closest_on(const Surface& surface, const Ray& ray, const Tree& tree,
                              const Ray& way, double off, TraversalCounts* counts) noexcept {
    const MeshRay mesh_ray(surface, ray);
    Hit closest;
    traverse(
        tree, way,
        [&](std::uint32_t triangle, double t_max) {
            const auto hit = mesh_ray.intersect(triangle, t_max);
            if (hit && is_closer(*hit, closest)) closest = *hit;
            return std::min(t_max, closest.t);
        },
        counts, off);
    if (closest.triangle == TriangleId::kNone) return std::nullopt;
    return closest;
}

}  // namespace

std::optional<Hit> closest_hit(MeshView mesh, const Tree& tree, const Ray& ray,
                               TraversalCounts* counts) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return std::nullopt;
    return closest_on(mesh, ray, tree, ray, 0, counts);
}

std::optional<Hit> closest_hit(const PlacedMesh& placed, const Tree& tree, const Ray& ray,
                               TraversalCounts* counts) noexcept {
    if (tree.is_empty() || tree.root().box.is_empty() || !is_traceable(ray)) return std::nullopt;
    const Ray local = local_ray(*placed.placement, ray);
    if (!is_traceable(local)) return closest_hit_brute_force(placed, ray, counts);
    const double off = placed.placement->rounding(ray.origin, largest_coordinate(tree.root().box));
    return closest_on(placed, ray, tree, local, off, counts);
}

}  // namespace boxwood
