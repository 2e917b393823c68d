// SPDX-License-Identifier: Apache-2.0
// Ray tracing a triangle mesh without any tree: test every triangle. Slow, simple, and the oracle
// for everything else. Explained in docs/algorithms/brute_force.md.
#include "boxwood/query/brute_force.h"

#include <vector>

#include "boxwood/query/mesh_ray.h"

namespace boxwood {

std::optional<Hit> closest_hit_brute_force(MeshView mesh, const Ray& ray,
                                           TraversalCounts* counts) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    const MeshRay mesh_ray(mesh, ray);
    // A vertex is shared by six triangles or so, but needs to be sheared only once.
    thread_local std::vector<double> scratch;
    scratch.resize(mesh.vertices.size());
    double* const x = scratch.data();
    for (std::size_t i = 0; i < scratch.size(); ++i) x[i] = mesh_ray.sheared().x(mesh.vertices[i]);

    std::optional<Hit> closest;
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        const Vec3i& face = mesh.faces[i];
        if (on_one_side(x[face[0]], x[face[1]], x[face[2]])) continue;
        const auto hit = mesh_ray.intersect(i, ray.t_max);
        if (hit && (!closest || is_closer(*hit, *closest))) closest = hit;
    }
    if (counts) counts->primitives += mesh.faces.size();
    return closest;
}

bool any_hit_brute_force(MeshView mesh, const Ray& ray) noexcept {
    if (!is_traceable(ray)) return false;
    const MeshRay mesh_ray(mesh, ray);
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        if (mesh_ray.intersect(i, ray.t_max)) return true;
    }
    return false;
}

}  // namespace boxwood
