// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/query/brute_force.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ClosestPointTest : public testing::Test {
protected:
    const TriangleMesh cube = subdivided_cube(4);
    const WideTree tree{cube, build_tree(cube)};
};

TEST_F(ClosestPointTest, is_found_from_inside_and_outside) {
    const auto inside = closest_point(cube, tree, {0.5, 0.45, 0.9});
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->distance, 0.1, 1e-15);
    EXPECT_EQ(inside->point, Vec3d(0.5, 0.45, 1));
    const auto corner = closest_point(cube, tree, {3, 3, 2});
    ASSERT_TRUE(corner);
    EXPECT_EQ(corner->distance, 3);
    EXPECT_EQ(corner->point, Vec3d(1, 1, 1));
}

TEST_F(ClosestPointTest, radius_is_inclusive) {
    EXPECT_TRUE(closest_point(cube, tree, {3, 3, 2}, 3));
    EXPECT_FALSE(closest_point(cube, tree, {3, 3, 2}, std::nextafter(3, 0)));
    EXPECT_TRUE(closest_point(cube, tree, {1, 0.3, 0.3}, 0));
    EXPECT_FALSE(closest_point(cube, tree, {0.5, 0.3, 0.3}, 0));
}

TEST_F(ClosestPointTest, equal_distances_go_to_the_lowest_triangle) {
    const Vec3d points[] = {{0.5, 0.5, 0.5}, {1, 1, 1}, {0.5, 0.5, 1}, {2, 0.5, 0.5}, {0, 0, 0}};
    for (const Vec3d& point : points) {
        const auto found = closest_point(cube, tree, point);
        ASSERT_TRUE(found);
        for (std::uint32_t i = 0; i < found->triangle; ++i) {
            const TriangleMesh one = {cube.vertices, {cube.faces[i]}};
            EXPECT_GT(closest_point_brute_force(one, point)->distance, found->distance);
        }
    }
}

TEST_F(ClosestPointTest, nothing_is_near_a_point_that_is_none) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const Vec3d& point : {Vec3d(kNaN, 0, 0), Vec3d(0, kInfinity, 0), Vec3d(0, 0, -1e151)}) {
        EXPECT_FALSE(closest_point(cube, tree, point));
        EXPECT_FALSE(closest_point_brute_force(cube, point));
    }
    EXPECT_FALSE(closest_point(cube, tree, {0, 0, 0}, -1));
    EXPECT_FALSE(closest_point(cube, tree, {0, 0, 0}, kNaN));
    EXPECT_TRUE(closest_point(cube, tree, {1e149, 0, 0}));
}

TEST_F(ClosestPointTest, a_mesh_without_triangles_is_near_nothing) {
    EXPECT_FALSE(closest_point(TriangleMesh(), WideTree(), {0, 0, 0}));
    EXPECT_FALSE(closest_point_brute_force(TriangleMesh(), {0, 0, 0}));
    std::vector<ClosestPoint> results(1, ClosestPoint{.triangle = 5});
    closest_points(TriangleMesh(), WideTree(), std::vector<Vec3d>{{0, 0, 0}}, results);
    EXPECT_FALSE(results[0].is_found());
}

TEST_F(ClosestPointTest, batch_wants_a_place_for_each_result) {
    std::vector<Vec3d> points(3, Vec3d(0, 0, 0));
    std::vector<ClosestPoint> results(2);
    EXPECT_THROW(closest_points(cube, tree, points, results), InvalidInput);
}

TEST_F(ClosestPointTest, batch_answers_what_has_no_answer) {
    std::vector<Vec3d> points(50'000, Vec3d(2, 0.5, 0.5));
    for (std::size_t i = 0; i < points.size(); i += 7) points[i].y() = std::nan("");
    std::vector<ClosestPoint> results(points.size());
    closest_points(cube, tree, points, results);
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(results[i].is_found(), i % 7 != 0);
        ASSERT_EQ(results[i].distance, i % 7 != 0 ? 1 : kInfinity);
    }
}

}  // namespace
}  // namespace boxwood
