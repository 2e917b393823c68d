// SPDX-License-Identifier: Apache-2.0
// Ray tracing a triangle mesh without any tree: test every triangle. Slow, simple, and the oracle
// for everything else. Explained in docs/algorithms/brute_force.md.
#include "boxwood/query/brute_force.h"

#include "boxwood/query/crossings.h"
#include "boxwood/query/mesh_point.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/solid_angle.h"

namespace boxwood {

namespace {

template <class Surface>
std::optional<Hit> closest_on(const Surface& surface, const Ray& ray,
                              TraversalCounts* counts) noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    const MeshRay mesh_ray(surface, ray);
    std::optional<Hit> closest;
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        const auto hit = mesh_ray.intersect(i, ray.t_max);
        if (hit && (!closest || is_closer(*hit, *closest))) closest = hit;
    }
    if (counts) counts->primitives += face_count(surface);
    return closest;
}

template <class Surface>
bool any_on(const Surface& surface, const Ray& ray) noexcept {
    if (!is_traceable(ray)) return false;
    const MeshRay mesh_ray(surface, ray);
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (mesh_ray.intersect(i, ray.t_max)) return true;
    }
    return false;
}

template <class Surface>
std::optional<ClosestPoint> closest_to(const Surface& surface, const Vec3d& point,
                                       double max_radius) noexcept {
    if (!is_near_anything(point, max_radius)) return std::nullopt;
    MeshPoint mesh_point(surface, point, max_radius);
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (is_in_float_range(surface, i)) mesh_point.offer(i);
    }
    const ClosestPoint closest = mesh_point.closest();
    if (!closest.is_found()) return std::nullopt;
    return closest;
}

template <class Surface>
std::vector<std::uint32_t> touching_box(const Surface& surface, const Box3d& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (is_in_float_range(surface, i) && overlap(box, corners_of(surface, i)))
            found.push_back(i);
    }
    return found;
}

template <class Surface>
std::vector<std::uint32_t> touching_sphere(const Surface& surface, const Sphere3d& sphere) {
    std::vector<std::uint32_t> found;
    if (!is_near_anything(sphere.center, sphere.radius)) return found;
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (is_in_float_range(surface, i) &&
            distance_to(surface, i, sphere.center) <= sphere.radius)
            found.push_back(i);
    }
    return found;
}

template <class Surface>
bool touches_triangle(const Surface& surface, const TriangleCorners& triangle) noexcept {
    if (!can_overlap(triangle)) return false;
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (is_in_float_range(surface, i) && overlap(triangle, corners_of(surface, i))) return true;
    }
    return false;
}

}  // namespace

std::optional<Hit> closest_hit_brute_force(MeshView mesh, const Ray& ray,
                                           TraversalCounts* counts) noexcept {
    return closest_on(mesh, ray, counts);
}
std::optional<Hit> closest_hit_brute_force(const PlacedMesh& placed, const Ray& ray,
                                           TraversalCounts* counts) noexcept {
    return closest_on(placed, ray, counts);
}

bool any_hit_brute_force(MeshView mesh, const Ray& ray) noexcept { return any_on(mesh, ray); }
bool any_hit_brute_force(const PlacedMesh& placed, const Ray& ray) noexcept {
    return any_on(placed, ray);
}

std::vector<Hit> all_hits_brute_force(MeshView mesh, const Ray& ray) {
    std::vector<Hit> hits;
    add_crossings_brute_force(mesh, ray, 0, hits);
    sort_crossings(hits);
    return hits;
}

std::optional<ClosestPoint> closest_point_brute_force(MeshView mesh, const Vec3d& point,
                                                      double max_radius) noexcept {
    return closest_to(mesh, point, max_radius);
}
std::optional<ClosestPoint> closest_point_brute_force(const PlacedMesh& placed, const Vec3d& point,
                                                      double max_radius) noexcept {
    return closest_to(placed, point, max_radius);
}

std::vector<std::uint32_t> box_overlap_brute_force(MeshView mesh, const Box3d& box) {
    return touching_box(mesh, box);
}
std::vector<std::uint32_t> box_overlap_brute_force(const PlacedMesh& placed, const Box3d& box) {
    return touching_box(placed, box);
}

std::vector<std::uint32_t> sphere_overlap_brute_force(MeshView mesh, const Sphere3d& sphere) {
    return touching_sphere(mesh, sphere);
}
std::vector<std::uint32_t> sphere_overlap_brute_force(const PlacedMesh& placed,
                                                      const Sphere3d& sphere) {
    return touching_sphere(placed, sphere);
}

bool triangle_overlap_brute_force(MeshView mesh, const TriangleCorners& triangle) noexcept {
    return touches_triangle(mesh, triangle);
}
bool triangle_overlap_brute_force(const PlacedMesh& placed,
                                  const TriangleCorners& triangle) noexcept {
    return touches_triangle(placed, triangle);
}

double winding_number_brute_force(MeshView mesh, const Vec3d& point) noexcept {
    if (!point.allFinite()) return 0;
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        if (!triangle_box(mesh, i).is_empty())
            sum += solid_angle(point, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2));
    }
    return sum;
}

}  // namespace boxwood
