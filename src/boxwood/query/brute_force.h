// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/closest_point.h"
#include "boxwood/query/overlaps.h"
#include "boxwood/query/traverse.h"

namespace boxwood {

/// The answer of closest_hit(), by testing every triangle: the oracle of all trees. O(n), no
/// memory.
std::optional<Hit> closest_hit_brute_force(MeshView mesh, const Ray& ray,
                                           TraversalCounts* counts = nullptr) noexcept;
std::optional<Hit> closest_hit_brute_force(const PlacedMesh& placed, const Ray& ray,
                                           TraversalCounts* counts = nullptr) noexcept;

/// The answer of any_hit(), by testing triangles until one is hit. O(n).
bool any_hit_brute_force(MeshView mesh, const Ray& ray) noexcept;
bool any_hit_brute_force(const PlacedMesh& placed, const Ray& ray) noexcept;

/// The answer of all_hits() of query/all_hits.h, by testing every triangle. O(n).
std::vector<Hit> all_hits_brute_force(MeshView mesh, const Ray& ray);

/// The answer of closest_point(), by measuring the distance to every triangle. O(n).
std::optional<ClosestPoint> closest_point_brute_force(
    MeshView mesh, const Vec3d& point,
    double max_radius = std::numeric_limits<double>::infinity()) noexcept;
std::optional<ClosestPoint> closest_point_brute_force(
    const PlacedMesh& placed, const Vec3d& point,
    double max_radius = std::numeric_limits<double>::infinity()) noexcept;

/// The answer of winding_number() but for its errors, by summing up the solid angles of all
/// triangles. O(n).
double winding_number_brute_force(MeshView mesh, const Vec3d& point) noexcept;

/// The answers of box_overlap(), sphere_overlap() and triangle_overlap(), by testing every
/// triangle.
std::vector<std::uint32_t> box_overlap_brute_force(MeshView mesh, const Box3d& box);
std::vector<std::uint32_t> box_overlap_brute_force(const PlacedMesh& placed, const Box3d& box);
std::vector<std::uint32_t> sphere_overlap_brute_force(MeshView mesh, const Sphere3d& sphere);
std::vector<std::uint32_t> sphere_overlap_brute_force(const PlacedMesh& placed,
                                                      const Sphere3d& sphere);
bool triangle_overlap_brute_force(MeshView mesh, const TriangleCorners& triangle) noexcept;
bool triangle_overlap_brute_force(const PlacedMesh& placed,
                                  const TriangleCorners& triangle) noexcept;

}  // namespace boxwood
