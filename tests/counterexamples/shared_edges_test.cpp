// SPDX-License-Identifier: Apache-2.0
// What goes wrong elsewhere where triangles meet: rays that leak, hits that are counted twice.
#include <gtest/gtest.h>

#include "boxwood/query/all_hits.h"
#include "boxwood/query/certified_hits.h"
#include "counterexamples/tree_over.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// Two triangles over [0, 1]^2 at z = 0, with the diagonal from (0, 0) to (1, 1).
TriangleMesh square() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            .faces = {{0, 1, 2}, {0, 2, 3}}};
}

/// A ray through the common edge of two triangles passes between them.
TEST(Counterexample, leak_at_an_edge) {
    // On a tilt that no coordinate is exact on.
    TriangleMesh mesh = square();
    for (Vec3d& p : mesh.vertices) p = {0.1 * p.x() + 0.3 * p.y(), p.x() / 3, p.y() / 7};
    const WideTree tree = tree_over(mesh);
    const Vec3d &a = mesh.vertices[0], &b = mesh.vertices[2];
    for (int i = 1; i < 1000; ++i) {
        const Vec3d on_edge = a + i / 1000.0 * (b - a), origin(0.7, -0.3 * i, 11);
        const Ray ray = {.origin = origin, .direction = on_edge - origin};
        ASSERT_TRUE(closest_hit(mesh, tree, ray)) << i;
        ASSERT_TRUE(any_hit(mesh, tree, ray)) << i;
        ASSERT_EQ(count_hits(mesh, tree, ray), 1u) << i;
    }
}

/// A ray straight into the corner of a box, where six triangles meet, escapes.
TEST(Counterexample, leak_at_a_vertex) {
    const TriangleMesh cube = subdivided_cube(2);
    const WideTree tree = tree_over(cube);
    for (const Vec3d& corner : cube.vertices) {
        for (const Vec3d& origin : {Vec3d(0.5, 0.5, 0.5), Vec3d(0.3, 0.6, 0.1)}) {
            const Ray ray = {.origin = origin, .direction = corner - origin};
            EXPECT_TRUE(any_hit(cube, tree, ray)) << corner.transpose();
            EXPECT_EQ(count_hits(cube, tree, ray) % 2, 1u) << corner.transpose();
        }
    }
}

/// A ray through the middle of a square is counted for both triangles at its diagonal.
TEST(Counterexample, edge_hit_counted_twice) {
    const TriangleMesh mesh = square();
    const WideTree tree = tree_over(mesh);
    for (const double s : {0.25, 0.5, 0.75}) {
        const std::vector<Hit> hits = all_hits(mesh, tree, {.origin = {s, s, 1}});
        ASSERT_EQ(hits.size(), 1u) << s;
        EXPECT_EQ(hits[0].t, 1);
    }
}

/// A ray through the vertex that many triangles share is counted for each of them.
TEST(Counterexample, vertex_hit_counted_many_times) {
    const TriangleMesh grid = flat_grid(4);
    const WideTree tree = tree_over(grid);
    EXPECT_EQ(count_hits(grid, tree, {.origin = {2, 2, 1}}), 1u);
    EXPECT_EQ(count_hits(grid, tree, {.origin = {1.5, -1, 1}, .direction = {0.25, 1.5, -0.5}}), 1u);
}

/// A ray that touches the rim of a body counts once, so that all behind it is inside out.
TEST(Counterexample, grazed_edge_counted_once) {
    const TriangleMesh cube = subdivided_cube(1);
    const WideTree tree = tree_over(cube);
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 0.5, 1.0}) {
            const Ray down = {.origin = {x, y, 3}};
            EXPECT_EQ(count_hits(cube, tree, down) % 2, 0u) << x << " " << y;
            // Across the edge from corner to corner.
            const Ray aslant = {.origin = {x - 1, y, 2 - x}, .direction = {1, 0, x - 1}};
            EXPECT_EQ(count_hits(cube, tree, aslant) % 2, 0u) << x << " " << y;
        }
}

/// A ray in the plane of a face counts it, or every triangle in it.
TEST(Counterexample, ray_in_the_plane_of_a_face_counts_it) {
    const TriangleMesh cube = subdivided_cube(4);
    const WideTree tree = tree_over(cube);
    for (const double y : {0.1, 0.25, 0.5}) {
        const std::size_t count =
            count_hits(cube, tree, {.origin = {-1, y, 1}, .direction = {1, 0, 0}});
        EXPECT_TRUE(count == 0 || count == 2) << count;
    }
}

}  // namespace
}  // namespace boxwood
