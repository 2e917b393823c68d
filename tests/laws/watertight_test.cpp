// SPDX-License-Identifier: Apache-2.0
// No ray gets out of a closed mesh, wherever between its triangles it tries to.
#include <gtest/gtest.h>

#include "boxwood/mesh/inspect.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/closest_hit.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/closed_meshes.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

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

TEST(Watertight, no_ray_escapes_from_a_closed_mesh) {
    constexpr std::uint64_t kSeed = 1;
    for (const ClosedMesh& closed : closed_meshes()) {
        ASSERT_TRUE(inspect(closed.mesh).closed) << closed.name;
        const MeshView mesh = closed.mesh;
        const Tree tree = build_tree(mesh);
        Random random(kSeed);
        for (const Vec3d& origin : points_inside(closed, random)) {
            std::vector<Vec3d> targets(mesh.vertices.begin(), mesh.vertices.end());
            for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
                for (int k = 0; k < 3; ++k) {
                    const Vec3d &a = mesh.corner(face, k), &b = mesh.corner(face, (k + 1) % 3);
                    const double s = random.number();
                    targets.emplace_back(0.5 * (a + b));
                    targets.emplace_back((1 - s) * a + s * b);
                }
            }
            for (std::size_t i = 0; i < targets.size(); i += kThinning) {
                const Vec3d& target = targets[i];
                const Ray ray = {.origin = origin, .direction = target - origin};
                ASSERT_TRUE(closest_hit(mesh, tree, ray) && any_hit(mesh, tree, ray))
                    << closed.name << ", seed " << kSeed << ", from " << origin.transpose()
                    << " to " << target.transpose();
            }
        }
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
