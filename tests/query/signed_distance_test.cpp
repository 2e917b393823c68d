// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/ray_parity.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

WideTree tree_over(const TriangleMesh& mesh) { return {mesh, build_tree(mesh)}; }

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Vec3i& face : other.faces)
        mesh.faces.emplace_back(face[0] + offset, face[1] + offset, face[2] + offset);
}

double signed_distance_at(const TriangleMesh& mesh, const Vec3d& point, SignMethod method,
                          bool is_undefined = false) {
    const MeshSign sign(mesh, method);
    const auto found = signed_distance(mesh, tree_over(mesh), sign, point);
    EXPECT_TRUE(found);
    EXPECT_EQ(found->is_undefined, is_undefined);
    return found->distance;
}

TEST(SignedDistance, is_negative_inside) {
    const TriangleMesh cube = subdivided_cube(4);
    for (const auto& [name, method] : sign_methods()) {
        EXPECT_NEAR(signed_distance_at(cube, {0.5, 0.45, 0.9}, method), -0.1, 1e-15) << name;
        EXPECT_NEAR(signed_distance_at(cube, {0.5, 0.45, 1.5}, method), 0.5, 1e-15) << name;
        EXPECT_EQ(signed_distance_at(cube, {3, 3, 2}, method), 3) << name;
    }
}

/// A spike: seen from beyond its tip, some of its sides look away.
TEST(SignedDistance, is_right_beyond_the_tip_of_a_spike) {
    const TriangleMesh spike = {
        .vertices = {{0, 0, 10}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}},
        .faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    const WideTree tree = tree_over(spike);
    const MeshSign sign(spike);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d point(random.number(-1, 1), random.number(-1, 1), random.number(10, 12));
        const auto found = signed_distance(spike, tree, sign, point);
        ASSERT_GT(found->distance, 0) << point.transpose();
    }
}

TEST(SignedDistance, an_open_mesh_leaves_it_undefined) {
    TriangleMesh open = subdivided_cube(2);
    open.faces.pop_back();
    signed_distance_at(open, {0.5, 0.5, 0.4}, SignMethod::pseudonormal, true);
    signed_distance_at(open, {0.5, 0.5, 0.4}, SignMethod::ray_parity, true);
    // Far from a small hole the winding number is as good as whole; next to it nobody knows.
    EXPECT_LT(signed_distance_at(open, {0.2, 0.2, 0.2}, SignMethod::winding_number), 0);
    const TriangleMesh sheet = flat_grid(4);
    EXPECT_FALSE(MeshSign(sheet, SignMethod::pseudonormal).is_trustworthy());
    signed_distance_at(sheet, {2, 2, 0.1}, SignMethod::winding_number, true);
}

TEST(SignedDistance, triangles_that_face_both_ways_leave_pseudonormals_undefined) {
    TriangleMesh mixed = subdivided_cube(2);
    std::swap(mixed.faces[3][0], mixed.faces[3][1]);
    signed_distance_at(mixed, {0.4, 0.45, 0.3}, SignMethod::pseudonormal, true);
    EXPECT_LT(signed_distance_at(mixed, {0.4, 0.45, 0.3}, SignMethod::ray_parity), 0);
    EXPECT_GT(signed_distance_at(mixed, {0.4, 0.45, 1.3}, SignMethod::ray_parity), 0);
}

TEST(SignedDistance, a_triangle_of_zero_area_in_a_seam_does_no_harm) {
    // A tetrahedron with a corner put onto an edge, on one side of it only, and the gap filled by a
    // triangle of zero area.
    const TriangleMesh mesh = {
        .vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
        .faces = {{0, 1, 4}, {0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const WideTree tree = tree_over(mesh);
    const MeshSign sign(mesh);
    ASSERT_TRUE(sign.is_trustworthy());
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d point = random.point(-1, 2);
        const bool inside = (point.array() > 0).all() && point.sum() < 2;
        const auto found = signed_distance(mesh, tree, sign, point);
        ASSERT_EQ(found->distance < 0, inside) << point.transpose();
    }
}

TEST(Pseudonormals, there_are_none_where_triangles_lean_over_each_other) {
    const TriangleMesh wedge = {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {0, 1, -0.1}},
                                .faces = {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
    const Pseudonormals of_wedge(wedge);
    ASSERT_TRUE(of_wedge.is_consistent());
    EXPECT_FALSE(of_wedge.at(0, TrianglePart::face));
    EXPECT_FALSE(of_wedge.at(0, TrianglePart::edge_ab));
    const TriangleMesh cube = subdivided_cube(1);
    const Pseudonormals of_cube(cube);
    for (std::uint32_t i = 0; i < cube.faces.size(); ++i) {
        for (int part = 0; part < 7; ++part)
            EXPECT_TRUE(of_cube.at(i, static_cast<TrianglePart>(part))) << i << " " << part;
    }
}

TEST(SignedDistance, corners_of_one_place_are_one_whatever_their_index) {
    const TriangleMesh cube = subdivided_cube(2);
    TriangleMesh soup;
    for (const Vec3i& face : cube.faces) {
        const int first = static_cast<int>(soup.vertices.size());
        for (const int corner : face) soup.vertices.push_back(cube.vertices[corner]);
        soup.faces.emplace_back(first, first + 1, first + 2);
    }
    EXPECT_TRUE(MeshSign(soup).is_trustworthy());
    EXPECT_EQ(signed_distance_at(soup, {2, 2, 1.5}, SignMethod::pseudonormal), 1.5);
}

TEST(SignedDistance, nothing_within_the_radius_has_no_sign) {
    const TriangleMesh cube = subdivided_cube(2);
    const WideTree tree = tree_over(cube);
    const MeshSign sign(cube);
    EXPECT_FALSE(signed_distance(cube, tree, sign, {3, 0.5, 0.5}, 1));
    const std::vector<Vec3d> points = {{3, 0.5, 0.5}, {1.5, 0.5, 0.5}, {std::nan(""), 0, 0}};
    std::vector<SignedDistance> results(3);
    signed_distances(cube, tree, sign, points, results, 1);
    EXPECT_FALSE(results[0].closest.is_found());
    EXPECT_TRUE(results[0].is_undefined);
    EXPECT_EQ(results[1].distance, 0.5);
    EXPECT_FALSE(results[1].is_undefined);
    EXPECT_EQ(results[2].distance, std::numeric_limits<double>::infinity());
    results.pop_back();
    EXPECT_THROW(signed_distances(cube, tree, sign, points, results), InvalidInput);
}

TEST(RayParity, tries_other_rays_where_one_meets_an_edge) {
    const TriangleMesh cube = subdivided_cube(4);
    const WideTree tree = tree_over(cube);
    // Where the first ray leaves through a corner of the cube's squares.
    const Vec3d point = Vec3d(0.5, 0.5, 1) - 0.5 * Vec3d(0.6174, 0.3391, 0.7096);
    EXPECT_EQ(is_inside_by_parity(cube, tree, point), true);
    EXPECT_EQ(is_inside_by_parity(cube, tree, {0.5, 0.5, 1.5}), false);
    EXPECT_EQ(is_inside_by_parity(TriangleMesh(), WideTree(), {0, 0, 0}), false);
    EXPECT_EQ(is_inside_by_parity(cube, tree, {1e17, 0.5, 0.5}), false);
}

TEST(RayParity, counts_two_walls_in_one_place) {
    TriangleMesh two = subdivided_cube(2);
    append(two, moved(subdivided_cube(1), 1, {0, 0, 1}));
    const WideTree tree = tree_over(two);
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d point(random.number(0, 1), random.number(0, 1), random.number(0, 2.5));
        const auto inside = is_inside_by_parity(two, tree, point);
        ASSERT_EQ(inside.value_or(point.z() < 2), point.z() < 2) << point.transpose();
    }
}

}  // namespace
}  // namespace boxwood
