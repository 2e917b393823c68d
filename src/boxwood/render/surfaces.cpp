// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/surfaces.h"

#include <algorithm>
#include <memory>

#include "boxwood/core/ray_sphere.h"

namespace boxwood {

namespace {

std::vector<SceneMesh> meshes_of(const World& world) {
    std::vector<SceneMesh> result;
    for (const MeshObject& object : world.meshes) result.emplace_back(object.mesh);
    return result;
}

std::vector<Box3f> sphere_boxes(const World& world) {
    std::vector<Box3f> boxes;
    for (const Sphere& sphere : world.spheres) {
        // Room for the rounding of the sphere test, which isn't exact as that of triangles is.
        const Vec3d reach = Vec3d::Constant(sphere.radius * (1 + 1e-6));
        boxes.push_back(rounded_outward({sphere.center - reach, sphere.center + reach}));
    }
    return boxes;
}

Ray shortened_to(Ray ray, double t_max) {
    ray.t_max = t_max;
    return ray;
}

}  // namespace

Surfaces::Surfaces(const World& world, const SceneOptions& options)
    : world_(world),
      scene_(meshes_of(world), options),
      sphere_tree_(build_tree(sphere_boxes(world))) {}

std::optional<double> Surfaces::intersect(const Ray& ray, std::uint32_t sphere,
                                          double t_max) const {
    const auto& [center, radius, material] = world_.spheres[sphere];
    return intersect_sphere(shortened_to(ray, t_max), center, radius,
                            ray.skip == sphere_id(sphere));
}

TriangleId Surfaces::sphere_id(std::uint32_t sphere) const {
    return {static_cast<std::uint32_t>(world_.meshes.size()), sphere};
}

std::optional<SurfaceHit> Surfaces::closest_hit(const Ray& ray, TraversalCounts* counts) const {
    const auto on_mesh = counts ? scene_.closest_hit(ray, *counts) : scene_.closest_hit(ray);
    return closest_of(ray, on_mesh.value_or(Hit{}), counts);
}

SurfaceHits Surfaces::closest_hits(std::span<const Ray> rays) const {
    std::vector<Hit> on_meshes(rays.size());
    scene_.closest_hits(rays, on_meshes, {.on_this_thread = true});
    SurfaceHits hits;
    hits.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits.push_back(closest_of(rays[i], on_meshes[i]));
    return hits;
}

/// The hit on a mesh, or a closer one on a sphere.
std::optional<SurfaceHit> Surfaces::closest_of(const Ray& ray, const Hit& on_mesh,
                                               TraversalCounts* counts) const {
    if (!is_traceable(ray)) return std::nullopt;
    double t = on_mesh.is_hit() ? on_mesh.t : ray.t_max;
    std::optional<std::uint32_t> closest_sphere;
    if (!sphere_tree_.is_empty()) {
        const auto visit = [&](std::uint32_t sphere, double t_max) {
            const auto found = intersect(ray, sphere, t_max);
            // Equal distances go to meshes, then to the first sphere.
            const bool wins =
                found && (*found < t || (closest_sphere ? *found == t && sphere < *closest_sphere
                                                        : !on_mesh.is_hit()));
            if (!wins) return t_max;
            closest_sphere = sphere;
            return t = *found;
        };
        traverse(sphere_tree_, shortened_to(ray, t), visit, counts);
    }

    if (closest_sphere) {
        const Sphere& sphere = world_.spheres[*closest_sphere];
        const Vec3d point = ray.at(t);
        return SurfaceHit{.t = t,
                          .point = point,
                          .normal = (point - sphere.center).normalized(),
                          .material = &world_.materials[sphere.material],
                          .id = sphere_id(*closest_sphere)};
    }
    if (!on_mesh.is_hit()) return std::nullopt;
    const MeshObject& object = world_.meshes[on_mesh.instance];
    return SurfaceHit{.t = t,
                      .point = ray.at(t),
                      .normal = geometric_normal(object.mesh, on_mesh.triangle),
                      .material = &world_.materials[object.material],
                      .id = {on_mesh.instance, on_mesh.triangle}};
}

bool Surfaces::any_hit(const Ray& ray) const { return scene_.any_hit(ray) || hits_sphere(ray); }

std::vector<bool> Surfaces::any_hits(std::span<const Ray> rays) const {
    const auto on_meshes = std::make_unique<bool[]>(rays.size());
    scene_.any_hits(rays, {on_meshes.get(), rays.size()}, {.on_this_thread = true});
    std::vector<bool> hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = on_meshes[i] || hits_sphere(rays[i]);
    return hits;
}

bool Surfaces::hits_sphere(const Ray& ray) const {
    if (sphere_tree_.is_empty() || !is_traceable(ray)) return false;
    bool found = false;
    traverse(sphere_tree_, ray, [&](std::uint32_t sphere, double t_max) {
        found = found || intersect(ray, sphere, t_max);
        return found ? kEndOfWalk : t_max;
    });
    return found;
}

}  // namespace boxwood
