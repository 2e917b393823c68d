// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"

namespace boxwood {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriangleMesh one_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return {{a, b, c}, {{0, 1, 2}}};
}

std::string complaint_about(const TriangleMesh& mesh) {
    try {
        check_indices(mesh);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "none";
}

TEST(AreFloats, one_coordinate_that_is_no_float_is_found_anywhere) {
    constexpr float kFloats[] = {0, -0.0f, 1, -0.1f, FLT_MAX, -FLT_MAX, FLT_MIN, 1 + FLT_EPSILON};
    std::vector<Vec3d> vertices;
    for (std::size_t i = 0; i < 10'000; ++i)
        vertices.emplace_back(kFloats[i % 8], kFloats[i / 8 % 8], kFloats[i / 64 % 8]);
    vertices[77] = {kNaN, -kInfinity, kInfinity};
    EXPECT_TRUE(are_floats({}));
    EXPECT_TRUE(are_floats(vertices));
    for (const double x : {0.1, -0.1, 1 + 0x1p-24, std::nextafter(double{FLT_MAX}, kInfinity),
                           -1e39, DBL_MAX, 1e-40, DBL_TRUE_MIN}) {
        for (const std::size_t place : {0, 4095, 4096, 9999}) {
            for (int k = 0; k < 3; ++k) {
                const double before = std::exchange(vertices[place][k], x);
                EXPECT_FALSE(are_floats(vertices)) << x << " at " << place << ' ' << k;
                vertices[place][k] = before;
            }
        }
    }
}

TEST(CheckIndices, accepts_indices_in_range_and_meshes_without_faces) {
    EXPECT_EQ(complaint_about({}), "none");
    EXPECT_EQ(complaint_about({{Vec3d::Zero()}, {}}), "none");
    EXPECT_EQ(complaint_about({{Vec3d::Zero()}, {{0, 0, 0}}}), "none");
}

TEST(CheckIndices, names_the_first_bad_face) {
    TriangleMesh mesh = generate_icosphere(20);
    mesh.faces[7][1] = 12;
    mesh.faces[9][1] = -5;
    EXPECT_EQ(complaint_about(mesh), "face 7 has vertex index 12, expected 0 to 11");
    mesh.faces[3][0] = -1;
    EXPECT_EQ(complaint_about(mesh), "face 3 has vertex index -1, expected 0 to 11");
}

TEST(TriangleBoxes, contain_their_triangles_and_are_as_tight_as_floats_allow) {
    const TriangleMesh mesh = generate_soup(5000);
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    ASSERT_EQ(boxes.size(), mesh.faces.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Box3d exact;
        for (int k = 0; k < 3; ++k) exact.extend(MeshView(mesh).corner(i, k));
        const Box3d box{boxes[i].lo.cast<double>(), boxes[i].hi.cast<double>()};
        EXPECT_TRUE(box.contains(exact)) << i;
        EXPECT_LE((box.extent() - exact.extent()).maxCoeff(), 0x1p-22) << i;
    }
}

TEST(TriangleBoxes, are_empty_where_a_corner_is_not_finite_or_beyond_float) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, 1e39, -1e300}) {
        for (int corner = 0; corner < 3; ++corner) {
            TriangleMesh mesh = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
            mesh.vertices[static_cast<std::size_t>(corner)].y() = bad;
            EXPECT_TRUE(triangle_boxes(mesh)[0].is_empty()) << bad << " at " << corner;
        }
    }
}

TEST(TriangleCentroids, are_the_means_of_the_corners) {
    const TriangleMesh mesh = one_triangle({0, 0, 3}, {3, 0, 0}, {0, 6, 0});
    EXPECT_EQ(triangle_centroids(mesh)[0], Vec3d(1, 2, 1));
}

TEST(Bounds, skip_vertices_that_are_not_finite) {
    TriangleMesh mesh = one_triangle({0, 0, 3}, {3, 0, 0}, {0, -6, 0});
    mesh.vertices.emplace_back(kNaN, 100, 100);
    mesh.vertices.emplace_back(100, kInfinity, 100);
    EXPECT_EQ(bounds(mesh), (Box3d{{0, -6, 0}, {3, 0, 3}}));
    EXPECT_TRUE(bounds({}).is_empty());
}

TEST(GeometricNormal, points_to_where_the_corners_turn_counter_clockwise) {
    EXPECT_EQ(geometric_normal(one_triangle({0, 0, 5}, {2, 0, 5}, {0, 3, 5}), 0), Vec3d(0, 0, 1));
    EXPECT_EQ(geometric_normal(one_triangle({0, 0, 5}, {0, 3, 5}, {2, 0, 5}), 0), Vec3d(0, 0, -1));
}

TEST(GeometricNormal, is_zero_for_a_triangle_of_zero_area) {
    EXPECT_EQ(geometric_normal(one_triangle({1, 1, 1}, {2, 2, 2}, {3, 3, 3}), 0), Vec3d(0, 0, 0));
}

}  // namespace
}  // namespace boxwood
