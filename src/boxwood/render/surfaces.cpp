// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "boxwood/core/ray_sphere.h"
#include "boxwood/core/round_outward.h"

namespace boxwood {

namespace {

std::vector<SceneMesh> meshes_of(const World& world) {
    std::vector<SceneMesh> result;
    for (const MeshData& mesh : world.meshes) result.emplace_back(mesh);
    return result;
}

std::vector<Instance> instances_of(const World& world) {
    std::vector<Instance> result;
    for (const MeshObject& object : world.objects)
        result.push_back(
            {.mesh = static_cast<std::uint32_t>(object.mesh), .to_world = object.to_world});
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
      scene_(meshes_of(world), instances_of(world), options),
      sphere_tree_(build_tree(sphere_boxes(world))) {
    for (const Material& material : world.materials) {
        has_unseen_places_ |= material.culls_back_faces || material.opacity_cutoff;
        has_clear_places_ |= material.opacity_cutoff || material.blends || material.opacity < 1;
    }
}

std::optional<double> Surfaces::intersect(const Ray& ray, std::uint32_t sphere,
                                          double t_max) const {
    const auto& [center, radius, material] = world_.spheres[sphere];
    return intersect_sphere(shortened_to(ray, t_max), center, radius,
                            ray.skip == sphere_id(sphere));
}

TriangleId Surfaces::sphere_id(std::uint32_t sphere) const {
    return {static_cast<std::uint32_t>(world_.objects.size()), sphere};
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
std::optional<SurfaceHit> Surfaces::closest_of(const Ray& ray, const Hit& first_on_mesh,
                                               TraversalCounts* counts) const {
    if (!is_traceable(ray)) return std::nullopt;
    Hit mesh_hit = first_on_mesh;
    std::optional<SurfaceFinish> finish;
    if (has_unseen_places_)
        finish = first_that_stops(ray, mesh_hit, [](const SurfaceFinish& f) { return !f.is_seen; });
    double t = mesh_hit.is_hit() ? mesh_hit.t : ray.t_max;
    std::optional<std::uint32_t> closest_sphere;
    if (!sphere_tree_.is_empty()) {
        const auto visit = [&](std::uint32_t sphere, double t_max) {
            const auto found = intersect(ray, sphere, t_max);
            // Equal distances go to meshes, then to the first sphere.
            const bool wins =
                found && (*found < t || (closest_sphere ? *found == t && sphere < *closest_sphere
                                                        : !mesh_hit.is_hit()));
            if (!wins) return t_max;
            closest_sphere = sphere;
            return t = *found;
        };
        traverse(sphere_tree_, shortened_to(ray, t), visit, counts);
    }

    if (closest_sphere) {
        const Sphere& sphere = world_.spheres[*closest_sphere];
        const Vec3d point = ray.at(t);
        const Vec3d normal = (point - sphere.center).normalized();
        const Material& material = world_.materials[sphere.material];
        return SurfaceHit{.t = t,
                          .point = point,
                          .normal = normal,
                          .shading_normal = normal,
                          .material = &material,
                          .emission = material.emission,
                          .opacity = material.opacity,
                          .id = sphere_id(*closest_sphere)};
    }
    if (!mesh_hit.is_hit()) return std::nullopt;
    if (!finish) finish = finish_at(world_, scene_, ray, mesh_hit);
    return SurfaceHit{.t = mesh_hit.t,
                      .point = ray.at(mesh_hit.t),
                      .normal = finish->normal,
                      .shading_normal = finish->shading_normal,
                      .material = finish->material,
                      .color = finish->color,
                      .emission = finish->emission,
                      .opacity = finish->opacity,
                      .id = {mesh_hit.instance, mesh_hit.triangle}};
}

/// Goes on from the hit to the first one that the ray doesn't pass, and returns what that one looks
/// like; nothing when there is none. Two triangles may lie in one place, so that the ray first
/// looks for another one there before it goes on.
template <class Passes>
std::optional<SurfaceFinish> Surfaces::first_that_stops(Ray ray, Hit& hit,
                                                        const Passes& passes) const {
    while (hit.is_hit()) {
        const SurfaceFinish finish = finish_at(world_, scene_, ray, hit);
        if (!passes(finish)) return finish;
        const bool is_second = ray.t_min == hit.t;
        ray.t_min =
            is_second ? std::nextafter(hit.t, std::numeric_limits<double>::infinity()) : hit.t;
        ray.skip = {hit.instance, hit.triangle};
        hit = scene_.closest_hit(ray).value_or(Hit{});
    }
    return std::nullopt;
}

/// Whether a shadow falls: something is hit that is there and isn't mostly clear.
bool Surfaces::hits_mesh(const Ray& ray, bool is_hit) const {
    if (!is_hit || !has_clear_places_) return is_hit;
    Hit hit = scene_.closest_hit(ray).value_or(Hit{});
    return first_that_stops(ray, hit, [](const SurfaceFinish& f) { return f.opacity < 0.5; })
        .has_value();
}

bool Surfaces::any_hit(const Ray& ray) const {
    return hits_mesh(ray, scene_.any_hit(ray)) || hits_sphere(ray);
}

std::vector<bool> Surfaces::any_hits(std::span<const Ray> rays) const {
    const auto on_meshes = std::make_unique<bool[]>(rays.size());
    scene_.any_hits(rays, {on_meshes.get(), rays.size()}, {.on_this_thread = true});
    std::vector<bool> hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = hits_mesh(rays[i], on_meshes[i]) || hits_sphere(rays[i]);
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
