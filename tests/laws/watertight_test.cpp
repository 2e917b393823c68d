// SPDX-License-Identifier: Apache-2.0
// No ray gets out of a closed mesh, wherever between its triangles it tries to.
#include <gtest/gtest.h>

#include "boxwood/mesh/inspect.h"
#include "boxwood/query/all_hits.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/build_wide_tree.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/closed_meshes.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "rounded_to_float.h"

namespace boxwood {
namespace {

/// Points below the middle of some faces, and, exactly, the middle of the mesh where it is inside.
std::vector<Vec3d> points_inside(const ClosedMesh& closed, Random& random) {
    std::vector<Vec3d> points;
    const MeshView mesh = closed.mesh;
    for (int i = 0; i < 6; ++i) {
        const std::size_t face = random.index(mesh.faces.size());
        const Vec3d middle =
            (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3;
        points.push_back(middle - closed.thickness * geometric_normal(mesh, face));
    }
    if (closed.name.starts_with("icosphere") || closed.name.starts_with("cube"))
        points.push_back(bounds(mesh).centroid());
    return points;
}

/// Every vertex, and two places on every edge.
std::vector<Vec3d> vertices_and_edges(MeshView mesh, Random& random) {
    std::vector<Vec3d> targets(mesh.vertices.begin(), mesh.vertices.end());
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        for (int k = 0; k < 3; ++k) {
            const Vec3d &a = mesh.corner(face, k), &b = mesh.corner(face, (k + 1) % 3);
            const double s = random.number();
            targets.emplace_back(0.5 * (a + b));
            targets.emplace_back((1 - s) * a + s * b);
        }
    }
    return targets;
}

Rayf in_float(const Ray& ray) {
    Rayf result;
    for (int k = 0; k < 3; ++k) {
        result.origin[k] = static_cast<float>(ray.origin[k]);
        result.direction[k] = static_cast<float>(ray.direction[k]);
    }
    return result;
}

TEST(Watertight, no_ray_escapes_from_a_closed_mesh) {
    constexpr std::uint64_t kSeed = 1;
    for (const ClosedMesh& closed : closed_meshes()) {
        ASSERT_TRUE(inspect(closed.mesh).closed) << closed.name;
        const MeshView mesh = closed.mesh;
        const Tree tree = build_tree(mesh);
        const WideTree wide = build_wide_tree(mesh);
        Random random(kSeed);
        for (const Vec3d& origin : points_inside(closed, random)) {
            const std::vector<Vec3d> targets = vertices_and_edges(mesh, random);
            for (std::size_t i = 0; i < targets.size(); i += kThinning) {
                const Vec3d& target = targets[i];
                const Ray ray = {.origin = origin, .direction = target - origin};
                ASSERT_TRUE(closest_hit(mesh, tree, ray) && any_hit(mesh, tree, ray) &&
                            closest_hit(mesh, wide, ray) && any_hit(mesh, wide, ray))
                    << closed.name << ", seed " << kSeed << ", from " << origin.transpose()
                    << " to " << target.transpose();
            }
        }
    }
}

/// The vertices are rounded to float, which leaves a closed surface around what was deep inside.
TEST(Watertight, no_ray_in_float_escapes_from_a_closed_mesh) {
    std::vector<ClosedMesh> meshes = closed_meshes();
    for (int i = 0; i < 4; ++i) {
        const auto [name, mesh, thickness] = meshes[i];
        meshes.push_back(
            {name + "_large_and_far_away", moved(mesh, 1e6, {1e8, -1e7, 1e8}), 1e6 * thickness});
    }
    std::size_t tried = 0;
    for (const ClosedMesh& closed : meshes) {
        const Box3d box = bounds(closed.mesh);
        const double largest = box.lo.cwiseAbs().cwiseMax(box.hi.cwiseAbs()).maxCoeff();
        if (closed.thickness < 1e-5 * largest) continue;
        const WideTree tree = build_wide_tree(closed.mesh);
        Random random(1);
        // From the float that the ray starts at to the float that the vertex becomes.
        for (const Vec3d& origin : rounded_to_float(points_inside(closed, random))) {
            const std::vector<Vec3d> targets =
                rounded_to_float(vertices_and_edges(closed.mesh, random));
            std::vector<Rayf> rays;
            for (std::size_t i = 0; i < targets.size(); i += kThinning)
                rays.push_back(in_float({.origin = origin, .direction = targets[i] - origin}));
            std::vector<Hitf> hits(rays.size());
            closest_hits(tree, rays, hits);
            for (std::size_t i = 0; i < rays.size(); ++i)
                ASSERT_TRUE(hits[i].is_hit() && any_hit(tree, rays[i])) << closed.name << " " << i;
            tried += rays.size();
        }
    }
    EXPECT_GT(tried, 500'000u / kThinning);
}

/// Aimed at vertices and edges, and along edges and diagonals, which lie in the planes of
/// triangles.
TEST(Watertight, rays_from_outside_leave_as_often_as_they_enter) {
    for (const ClosedMesh& closed : closed_meshes()) {
        const MeshView mesh = closed.mesh;
        const WideTree tree = build_wide_tree(mesh);
        const Box3d box = bounds(mesh);
        const double size = box.extent().norm();
        Random random(1);
        std::vector<Ray> rays;
        for (const Vec3d& target : vertices_and_edges(mesh, random)) {
            const Vec3d origin = box.centroid() + 2 * size * random.direction();
            rays.push_back({.origin = origin, .direction = target - origin});
        }
        for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
            const Vec3d &a = mesh.corner(face, 0), &b = mesh.corner(face, 1);
            const Vec3d diagonal = 0.5 * (a + b) - mesh.corner(face, 2);
            for (const Vec3d& along : {Vec3d(b - a), diagonal}) {
                const Vec3d origin = a - 2 * size / along.norm() * along;
                rays.push_back({.origin = origin, .direction = along});
            }
        }
        for (std::size_t i = 0; i < rays.size(); i += kThinning)
            ASSERT_EQ(count_hits(mesh, tree, rays[i]) % 2, 0u) << closed.name << " " << i;
    }
}

/// The directions and coordinates are exact here, so the rays do pass through vertices and edges.
TEST(Watertight, rays_exactly_through_vertices_and_edges_hit) {
    const TriangleMesh mesh = subdivided_cube(8);
    for (const auto& [name, options] : all_builds()) {
        const Tree tree = build_tree(mesh, options);
        for (int i = 0; i <= 16; ++i) {
            for (int j = 0; j <= 16; ++j) {
                for (int axis = 0; axis < 3; ++axis) {
                    for (const double side : {-1.0, 2.0}) {
                        Ray ray;
                        ray.origin[axis] = side;
                        ray.origin[(axis + 1) % 3] = i / 16.0;
                        ray.origin[(axis + 2) % 3] = j / 16.0;
                        ray.direction.setZero();
                        ray.direction[axis] = side < 0 ? 1 : -1;
                        const auto hit = closest_hit(mesh, tree, ray);
                        ASSERT_TRUE(hit) << name << " " << i << " " << j << " axis " << axis;
                        EXPECT_EQ(hit->t, 1);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
