// SPDX-License-Identifier: Apache-2.0
// The tree is walked in float by the ray of near_ray.h; what that can't leave out is decided in
// double. Explained in docs/algorithms/certified_hits.md.
#include "boxwood/query/certified_hits.h"

#include <limits>

#include "boxwood/query/brute_force.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/near_ray.h"

namespace boxwood {

namespace {

template <class Surface>
std::optional<Hit> closest_on(const Surface& surface, const WideTree& tree,
                              const Ray& ray) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return std::nullopt;
    const NearRay near = near_ray(surface, tree, ray);
    if (!near.can_leave_out()) return closest_hit_brute_force(surface, ray);
    const MeshRay mesh_ray(surface, ray);
    Hit closest;
    double t_max = ray.t_max;
    float farthest = near.ray().t_max;
    auto visit = [&](std::uint32_t triangle) {
        const auto hit = mesh_ray.intersect(triangle, t_max);
        if (hit && is_closer(*hit, closest)) {
            closest = *hit;
            t_max = hit->t;
            farthest = near.farthest(t_max);
        }
        return farthest;
    };
    visit_candidates(tree, near, visit);
    if (closest.triangle == TriangleId::kNone) return std::nullopt;
    return closest;
}

template <class Surface>
bool any_on(const Surface& surface, const WideTree& tree, const Ray& ray) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return false;
    const NearRay near = near_ray(surface, tree, ray);
    if (!near.can_leave_out()) return any_hit_brute_force(surface, ray);
    const MeshRay mesh_ray(surface, ray);
    bool found = false;
    auto visit = [&](std::uint32_t triangle) {
        found = found || mesh_ray.intersect(triangle, ray.t_max);
        return found ? -std::numeric_limits<float>::infinity() : near.ray().t_max;
    };
    visit_candidates(tree, near, visit);
    return found;
}

}  // namespace

std::optional<Hit> closest_hit(MeshView mesh, const WideTree& tree, const Ray& ray) noexcept {
    return closest_on(mesh, tree, ray);
}
std::optional<Hit> closest_hit(const PlacedMesh& placed, const WideTree& tree,
                               const Ray& ray) noexcept {
    return closest_on(placed, tree, ray);
}

bool any_hit(MeshView mesh, const WideTree& tree, const Ray& ray) noexcept {
    return any_on(mesh, tree, ray);
}
bool any_hit(const PlacedMesh& placed, const WideTree& tree, const Ray& ray) noexcept {
    return any_on(placed, tree, ray);
}

}  // namespace boxwood
