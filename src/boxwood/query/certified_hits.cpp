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
void find_closest(const Surface& surface, const WideTree& tree, const Ray& ray,
                  Hit& closest) noexcept {
    closest = Hit{};
    if (tree.is_empty() || !is_traceable(ray)) return;
    const NearRay near = near_ray(surface, tree, ray);
    if (!near.can_leave_out()) {
        closest = closest_hit_brute_force(surface, ray).value_or(Hit{});
        return;
    }
    const MeshRay mesh_ray(surface, ray);
    double t_max = ray.t_max;
    float farthest = near.ray().t_max;
    auto visit = [&](const Candidate& candidate) {
        const auto hit = mesh_ray.intersect(candidate, t_max);
        if (hit && is_closer(*hit, closest)) {
            closest = *hit;
            t_max = hit->t;
            farthest = near.farthest(t_max);
        }
        return farthest;
    };
    visit_candidates(tree, near, visit);
}

template <class Surface>
std::optional<Hit> closest_on(const Surface& surface, const WideTree& tree,
                              const Ray& ray) noexcept {
    Hit closest;
    find_closest(surface, tree, ray, closest);
    if (!closest.is_hit()) return std::nullopt;
    return closest;
}

template <class Surface>
bool any_on(const Surface& surface, const WideTree& tree, const Ray& ray) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return false;
    const NearRay near = near_ray(surface, tree, ray);
    if (!near.can_leave_out()) return any_hit_brute_force(surface, ray);
    const MeshRay mesh_ray(surface, ray);
    bool found = false;
    auto visit = [&](const Candidate& candidate) {
        found = found || mesh_ray.intersect(candidate, ray.t_max);
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

void closest_hit(MeshView mesh, const WideTree& tree, const Ray& ray, Hit& hit) noexcept {
    find_closest(mesh, tree, ray, hit);
}

bool any_hit(MeshView mesh, const WideTree& tree, const Ray& ray) noexcept {
    return any_on(mesh, tree, ray);
}
bool any_hit(const PlacedMesh& placed, const WideTree& tree, const Ray& ray) noexcept {
    return any_on(placed, tree, ray);
}

}  // namespace boxwood
