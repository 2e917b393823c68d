// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/inspect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "mesh/small_meshes.h"

namespace boxwood {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return inspect(TriangleMesh{{a, b, c}, {{0, 1, 2}}}).degenerate_faces;
}

TEST(Inspect, a_tetrahedron_is_closed) {
    const MeshReport report = inspect(tetrahedron());
    EXPECT_EQ(report.vertices, 4u);
    EXPECT_EQ(report.faces, 4u);
    EXPECT_EQ(report.bounds, (Box3d{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_EQ(report.degenerate_faces, 0u);
    EXPECT_EQ(report.boundary_edges, 0u);
    EXPECT_EQ(report.nonmanifold_edges, 0u);
    EXPECT_EQ(report.flipped_edges, 0u);
    EXPECT_TRUE(report.closed);
}

TEST(Inspect, nothing_is_not_closed) {
    EXPECT_FALSE(inspect({}).closed);
    EXPECT_FALSE(inspect(TriangleMesh{{{0, 0, 0}}, {}}).closed);
    EXPECT_TRUE(inspect({}).bounds.is_empty());
}

TEST(Inspect, a_missing_face_leaves_three_boundary_edges) {
    TriangleMesh mesh = tetrahedron();
    mesh.faces.pop_back();
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.boundary_edges, 3u);
    EXPECT_FALSE(report.closed);
}

TEST(Inspect, a_turned_face_flips_its_three_edges_and_stays_closed) {
    TriangleMesh mesh = tetrahedron();
    std::swap(mesh.faces[1][0], mesh.faces[1][1]);
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.flipped_edges, 3u);
    EXPECT_TRUE(report.closed);
}

TEST(Inspect, a_fin_makes_an_edge_nonmanifold) {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.emplace_back(2, 2, 2);
    mesh.faces.emplace_back(0, 1, 4);
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.nonmanifold_edges, 1u);
    EXPECT_EQ(report.boundary_edges, 2u);
    EXPECT_FALSE(report.closed);
}

TEST(Inspect, a_face_that_is_there_twice_makes_its_edges_nonmanifold) {
    TriangleMesh mesh = tetrahedron();
    mesh.faces.push_back(mesh.faces[0]);
    EXPECT_EQ(inspect(mesh).nonmanifold_edges, 3u);
}

TEST(Inspect, faces_meet_where_positions_are_equal_whatever_the_indices) {
    EXPECT_TRUE(inspect(torn_apart(tetrahedron())).closed);
    EXPECT_TRUE(inspect(torn_apart(generate_gyroid(5000))).closed);
}

TEST(Inspect, plus_and_minus_zero_are_the_same_place) {
    TriangleMesh mesh = torn_apart(tetrahedron());
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 2)
        for (double& x : mesh.vertices[i])
            if (x == 0) x = -0.0;
    EXPECT_TRUE(inspect(mesh).closed);
}

TEST(Inspect, triangles_of_zero_area_are_degenerate) {
    EXPECT_EQ(degenerate({0, 0, 0}, {0, 0, 0}, {1, 0, 0}), 1u);
    EXPECT_EQ(degenerate({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), 1u);
    EXPECT_EQ(degenerate({0, 0, 0}, {1, 2, 3}, {3, 6, 9}), 1u);
    EXPECT_EQ(degenerate({0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {0.3, 0.2, 0.7}), 1u);
    EXPECT_EQ(degenerate({0, 0, 0}, {1e-200, 0, 0}, {2e-200, -0.0, 0}), 1u);
    EXPECT_EQ(degenerate({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0u);
}

TEST(Inspect, small_large_and_thin_triangles_are_not_degenerate) {
    EXPECT_EQ(degenerate({0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}), 0u);
    EXPECT_EQ(degenerate({0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}), 0u);
    EXPECT_EQ(degenerate({-3e38, 0, 0}, {3e38, 0, 0}, {0, 3e38, 0}), 0u);
    EXPECT_EQ(degenerate({0, 0, 0}, {1e30, 0, 0}, {1e30, 1e-250, 0}), 0u);
    EXPECT_EQ(degenerate({0, 0, 0}, {1, 1, 0}, {1 + 0x1p-52, 1, 0}), 0u);
}

TEST(Inspect, triangles_with_a_corner_that_no_box_holds_are_degenerate) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, 1e39, -1e300})
        EXPECT_EQ(degenerate({0, 0, 0}, {1, 0, 0}, {0, bad, 0}), 1u) << bad;
}

TEST(Inspect, vertices_that_are_not_finite_open_the_surface) {
    for (const double bad : {kNaN, kInfinity}) {
        TriangleMesh mesh = generate_icosphere(2000);
        mesh.vertices[3].z() = bad;  // a corner of the icosahedron, of five faces
        const MeshReport report = inspect(mesh);
        EXPECT_EQ(report.degenerate_faces, 5u);
        EXPECT_EQ(report.boundary_edges, 5u);
        EXPECT_FALSE(report.closed);
        EXPECT_TRUE(report.bounds.lo.allFinite() && report.bounds.hi.allFinite());
    }
}

TEST(Inspect, many_not_finite_vertices_do_not_disturb_the_others) {
    TriangleMesh mesh = generate_icosphere(2000);
    for (int i = 0; i < 5000; ++i) mesh.vertices.emplace_back(kNaN, i % 7, i % 2 ? kInfinity : -1);
    EXPECT_TRUE(inspect(mesh).closed);
}

TEST(Inspect, a_collapsed_face_between_two_whole_ones_leaves_them_neighbours) {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.push_back(mesh.vertices[1]);
    mesh.faces.emplace_back(0, 1, 4);
    mesh.faces.emplace_back(2, 2, 2);
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.degenerate_faces, 2u);
    EXPECT_TRUE(report.closed);
}

TEST(Inspect, a_sliver_that_fills_a_seam_counts_for_closedness) {
    // The edge from vertex 0 to vertex 1 is halved on one of its sides only.
    TriangleMesh mesh = tetrahedron();
    mesh.vertices.emplace_back(0.5, 0, 0);
    mesh.faces[0] = {0, 2, 4};
    mesh.faces.emplace_back(4, 2, 1);
    EXPECT_FALSE(inspect(mesh).closed);
    mesh.faces.emplace_back(0, 4, 1);
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.degenerate_faces, 1u);
    EXPECT_EQ(report.flipped_edges, 0u);
    EXPECT_TRUE(report.closed);
}

TEST(Inspect, area_and_volume_are_measured) {
    const MeshReport report = inspect(tetrahedron());
    EXPECT_NEAR(report.area, 1.5 + std::sqrt(3) / 2, 1e-12);
    EXPECT_NEAR(report.volume.value(), 1.0 / 6, 1e-12);
    const MeshReport ball = inspect(generate_icosphere(80000));
    EXPECT_NEAR(ball.volume.value(), 4.18879, 1e-3);
    EXPECT_NEAR(ball.area, 12.56637, 2e-3);
}

TEST(Inspect, volume_is_known_of_what_is_closed_and_turned_alike) {
    TriangleMesh mesh = tetrahedron();
    for (Vec3d& p : mesh.vertices) p += Vec3d(1e6, 1e6, 1e6);
    EXPECT_NEAR(inspect(mesh).volume.value(), 1.0 / 6, 1e-9);
    std::swap(mesh.faces[1][0], mesh.faces[1][1]);
    EXPECT_FALSE(inspect(mesh).volume);
    for (const std::size_t i : {0, 2, 3}) std::swap(mesh.faces[i][0], mesh.faces[i][1]);
    EXPECT_NEAR(inspect(mesh).volume.value(), -1.0 / 6, 1e-9);
    mesh.faces.pop_back();
    EXPECT_FALSE(inspect(mesh).volume);
    EXPECT_FALSE(inspect({}).volume);
}

TEST(Inspect, faces_that_are_there_again_are_duplicates_in_whatever_order) {
    TriangleMesh mesh = tetrahedron();
    EXPECT_EQ(inspect(mesh).duplicate_faces, 0u);
    mesh.faces.push_back(mesh.faces[0]);
    mesh.faces.emplace_back(mesh.faces[0][2], mesh.faces[0][1], mesh.faces[0][0]);
    mesh.faces.emplace_back(0, 0, 0);
    mesh.faces.emplace_back(0, 0, 0);
    EXPECT_EQ(inspect(mesh).duplicate_faces, 2u);
    EXPECT_EQ(inspect(torn_apart(mesh)).duplicate_faces, 2u);
}

TEST(Inspect, vertices_are_judged) {
    TriangleMesh mesh = torn_apart(tetrahedron());
    MeshReport report = inspect(mesh);
    EXPECT_EQ(report.duplicate_vertices, 8u);
    EXPECT_EQ(report.unreferenced_vertices, 0u);
    EXPECT_EQ(report.nonfinite_vertices, 0u);
    for (const double bad : {kNaN, kNaN, kInfinity, kInfinity})
        mesh.vertices.emplace_back(0, bad, 0);
    report = inspect(mesh);
    EXPECT_EQ(report.duplicate_vertices, 9u) << "NaN is no position, infinity is";
    EXPECT_EQ(report.unreferenced_vertices, 4u);
    EXPECT_EQ(report.nonfinite_vertices, 4u);
}

TEST(Inspect, components_are_joined_at_vertices) {
    TriangleMesh mesh = tetrahedron();
    EXPECT_EQ(inspect(mesh).components, 1u);
    EXPECT_EQ(inspect(torn_apart(mesh)).components, 1u);
    for (const Vec3d& p : tetrahedron().vertices) mesh.vertices.push_back(p + Vec3d(3, 0, 0));
    for (const Vec3i& face : tetrahedron().faces) mesh.faces.push_back(face + Vec3i(4, 4, 4));
    EXPECT_EQ(inspect(mesh).components, 2u);
    mesh.vertices[7] = mesh.vertices[1];
    EXPECT_EQ(inspect(mesh).components, 1u);
    EXPECT_EQ(inspect({}).components, 0u);
}

TEST(Inspect, boundary_edges_form_loops) {
    EXPECT_EQ(inspect(tetrahedron()).boundary_loops, 0u);
    EXPECT_EQ(inspect(generate_terrain(2000)).boundary_loops, 1u);
    TriangleMesh mesh = generate_icosphere(2000);
    mesh.faces.erase(mesh.faces.begin() + 1000);
    mesh.faces.erase(mesh.faces.begin());
    const MeshReport report = inspect(mesh);
    EXPECT_EQ(report.boundary_edges, 6u);
    EXPECT_EQ(report.boundary_loops, 2u);
}

TEST(Inspect, closedness_alone_is_the_same) {
    EXPECT_TRUE(is_closed(tetrahedron()));
    EXPECT_TRUE(is_closed(generate_gyroid(5000)));
    EXPECT_FALSE(is_closed(generate_terrain(500)));
    EXPECT_FALSE(is_closed({}));
}

TEST(Inspect, the_report_does_not_depend_on_the_number_of_threads) {
    TriangleMesh mesh = generate_soup(20000);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 5) mesh.vertices[i] = Vec3d::Zero();
    const MeshReport many = inspect(mesh);
    const ThreadLimit limit(1);
    const MeshReport one = inspect(mesh);
    EXPECT_EQ(one.degenerate_faces, many.degenerate_faces);
    EXPECT_EQ(one.boundary_edges, many.boundary_edges);
    EXPECT_EQ(one.nonmanifold_edges, many.nonmanifold_edges);
    EXPECT_EQ(one.flipped_edges, many.flipped_edges);
    EXPECT_EQ(one.area, many.area);
    EXPECT_EQ(one.duplicate_faces, many.duplicate_faces);
    EXPECT_EQ(one.components, many.components);
    EXPECT_EQ(one.boundary_loops, many.boundary_loops);
    const TriangleMesh ball = generate_gyroid(50000);
    EXPECT_EQ(inspect(ball).volume, [&] {
        const ThreadLimit eight(8);
        return inspect(ball).volume;
    }());
}

}  // namespace
}  // namespace boxwood
