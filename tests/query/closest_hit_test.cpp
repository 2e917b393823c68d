// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/closest_hit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boxwood/build/build.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/brute_force.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// Squares of side 2 about the z axis, at z = 0, -1, -2 ..., each of two triangles.
TriangleMesh sheets(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double z = -i;
        mesh.vertices.insert(mesh.vertices.end(),
                             {Vec3d(-1, -1, z), Vec3d(1, -1, z), Vec3d(1, 1, z), Vec3d(-1, 1, z)});
        mesh.faces.emplace_back(4 * i, 4 * i + 1, 4 * i + 2);
        mesh.faces.emplace_back(4 * i, 4 * i + 2, 4 * i + 3);
    }
    return mesh;
}

TEST(ClosestHit, is_the_first_along_the_ray) {
    const TriangleMesh mesh = sheets(10);
    const Tree tree = build_tree(mesh);
    const auto from_above = closest_hit(mesh, tree, {.origin = {0.5, 0.25, 5}});
    ASSERT_TRUE(from_above);
    EXPECT_EQ(from_above->t, 5);
    EXPECT_EQ(from_above->triangle, 0u);
    const auto from_below =
        closest_hit(mesh, tree, {.origin = {0.5, 0.25, -15}, .direction = {0, 0, 1}});
    ASSERT_TRUE(from_below);
    EXPECT_EQ(from_below->t, 6);
    EXPECT_EQ(from_below->triangle, 18u);
}

TEST(ClosestHit, barycentric_coordinates_give_the_point_of_the_ray) {
    const TriangleMesh sphere = generate_icosphere(500);
    const MeshView mesh = sphere;
    const Tree tree = build_tree(mesh);
    const Ray ray = {.origin = {3, 2, 1}, .direction = {-3, -1.9, -1.1}};
    const auto hit = closest_hit(mesh, tree, ray);
    ASSERT_TRUE(hit);
    const Vec3d point = (1 - hit->u - hit->v) * mesh.corner(hit->triangle, 0) +
                        hit->u * mesh.corner(hit->triangle, 1) +
                        hit->v * mesh.corner(hit->triangle, 2);
    EXPECT_NEAR((point - ray.at(hit->t)).norm(), 0, 1e-12);
}

TEST(ClosestHit, equal_distances_go_to_the_lowest_triangle) {
    // On the diagonal both triangles of a sheet are hit, on a common vertex more.
    const TriangleMesh mesh = sheets(10);
    const TriangleMesh grid = flat_grid(4);
    for (const auto& [name, method] : build_methods()) {
        const Tree tree = build_tree(mesh, {.method = method});
        EXPECT_EQ(closest_hit(mesh, tree, {.origin = {0.5, 0.5, -2.5}})->triangle, 6u) << name;
        const Tree grid_tree = build_tree(grid, {.method = method});
        const auto on_vertex = closest_hit(grid, grid_tree, {.origin = {2, 2, 1}});
        EXPECT_EQ(on_vertex->triangle, 10u) << name;  // of the square from (1, 1) to (2, 2)
    }
}

TEST(ClosestHit, skip_makes_a_triangle_invisible) {
    const TriangleMesh mesh = sheets(3);
    const Tree tree = build_tree(mesh);
    Ray ray = {.origin = {0.5, 0.25, 0}};
    EXPECT_EQ(closest_hit(mesh, tree, ray)->triangle, 0u);
    ray.skip = {0, 0};
    EXPECT_EQ(closest_hit(mesh, tree, ray)->triangle, 2u);
    ray.t_max = 0.5;
    EXPECT_FALSE(closest_hit(mesh, tree, ray));
    EXPECT_FALSE(any_hit(mesh, tree, ray));
}

TEST(ClosestHit, limits_are_inclusive) {
    const TriangleMesh mesh = sheets(5);
    const Tree tree = build_tree(mesh);
    const auto at = [&](double t_min, double t_max) {
        const auto hit =
            closest_hit(mesh, tree, {.origin = {0.5, 0.25, 1}, .t_min = t_min, .t_max = t_max});
        return hit ? hit->t : -1;
    };
    EXPECT_EQ(at(0, 1), 1);
    EXPECT_EQ(at(1, 9), 1);
    EXPECT_EQ(at(2, 2), 2);
    EXPECT_EQ(at(std::nextafter(2.0, 3.0), 9), 3);
    EXPECT_EQ(at(0, std::nextafter(1.0, 0.0)), -1);
    EXPECT_EQ(at(5.5, 9), -1);
}

TEST(ClosestHit, empty_mesh_is_never_hit) {
    const Tree tree = build_tree(TriangleMesh());
    EXPECT_FALSE(closest_hit(TriangleMesh(), tree, {}));
    EXPECT_FALSE(any_hit(TriangleMesh(), tree, {}));
    EXPECT_FALSE(closest_hit_brute_force(TriangleMesh(), {}));
    EXPECT_FALSE(any_hit_brute_force(TriangleMesh(), {}));
}

TEST(ClosestHit, tree_tests_few_of_many_triangles) {
    const TriangleMesh mesh = generate_icosphere(20'000);
    const Tree tree = build_tree(mesh);
    TraversalCounts with_tree, brute;
    const Ray ray = {.origin = {0.1, 0.2, 5}};
    closest_hit(mesh, tree, ray, &with_tree);
    closest_hit_brute_force(mesh, ray, &brute);
    EXPECT_EQ(brute.primitives, mesh.faces.size());
    EXPECT_EQ(brute.nodes, 0u);
    EXPECT_GT(with_tree.nodes, 1u);
    EXPECT_LT(with_tree.steps(), 200u);
}

TEST(ClosestHit, counts_add_up_over_queries) {
    const TriangleMesh mesh = sheets(10);
    const Tree tree = build_tree(mesh);
    TraversalCounts once, twice;
    const Ray ray = {.origin = {0.5, 0.25, 5}};
    closest_hit(mesh, tree, ray, &once);
    closest_hit(mesh, tree, ray, &twice);
    closest_hit(mesh, tree, ray, &twice);
    EXPECT_EQ(twice.nodes, 2 * once.nodes);
    EXPECT_EQ(twice.primitives, 2 * once.primitives);
}

}  // namespace
}  // namespace boxwood
