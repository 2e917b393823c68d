// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/ray_crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace boxwood {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How many of the triangles that go around the center, from one rim point to the next and on to
/// the first, a ray along z through (x, y) crosses.
int crossings_of_fan(const Vec3d& center, const std::vector<Vec3d>& rim, double x, double y) {
    const ShearedRay ray({.origin = {x, y, 5}, .direction = {0, 0, -1}});
    int count = 0;
    for (std::size_t i = 0; i < rim.size(); ++i)
        count += crossing(ray, center, rim[i], rim[(i + 1) % rim.size()], 0, kInfinity).has_value();
    return count;
}

TEST(RayCrossing, edge_functions_have_opposite_signs_from_both_sides) {
    const double numbers[] = {-1, -0x1p-60, -0.0, 0.0, 0x1p-60, 0.5, 3};
    for (const double px : numbers)
        for (const double py : numbers)
            for (const double qx : numbers)
                for (const double qy : numbers) {
                    EXPECT_EQ(side_of_edge(px, py, qx, qy), -side_of_edge(qx, qy, px, py));
                    EXPECT_EQ(side_of_edge(px, py, qx, qy) == 0, px == qx && py == qy);
                }
}

TEST(RayCrossing, vertex_and_edges_inside_a_surface_are_crossed_once) {
    for (int corners = 3; corners <= 12; ++corners) {
        for (const double tilt : {0.0, 0.5}) {
            std::vector<Vec3d> rim;
            for (int i = 0; i < corners; ++i) {
                const double angle = 6.283185307179586 * i / corners;
                rim.emplace_back(std::cos(angle), std::sin(angle), tilt * (i % 2));
            }
            EXPECT_EQ(crossings_of_fan({0, 0, 0}, rim, 0, 0), 1) << corners;
        }
    }
    const std::vector<Vec3d> square = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    EXPECT_EQ(crossings_of_fan({0, 0, 0}, square, 0.5, 0), 1);
    EXPECT_EQ(crossings_of_fan({0, 0, 0}, square, -0.5, 0), 1);
    EXPECT_EQ(crossings_of_fan({0, 0, 0}, square, 0, 0.5), 1);
    EXPECT_EQ(crossings_of_fan({0, 0, 0}, square, 0, -0.5), 1);
}

TEST(RayCrossing, a_tiling_gives_each_corner_and_edge_to_one_triangle) {
    // Two squares side by side, seen at all their corners, edge middles and diagonals; the right
    // and upper rim belong to whoever is next, the left and lower rim to these.
    for (int x = 0; x <= 4; ++x) {
        for (int y = 0; y <= 2; ++y) {
            const ShearedRay ray({.origin = {0.5 * x, 0.5 * y, 1}, .direction = {0, 0, -1}});
            int count = 0;
            for (const double left : {0.0, 1.0}) {
                const Vec3d a(left, 0, 0), b(left + 1, 0, 0), c(left + 1, 1, 0), d(left, 1, 0);
                count += crossing(ray, a, b, c, 0, kInfinity).has_value();
                count += crossing(ray, d, a, c, 0, kInfinity).has_value();
            }
            EXPECT_LE(count, 1) << x << " " << y;
            if (x > 0 && x < 4 && y == 1) {
                EXPECT_EQ(count, 1) << x << " " << y;
            }
        }
    }
}

TEST(RayCrossing, a_fold_is_crossed_twice_or_not_at_all) {
    int total = 0;
    for (int turn = 0; turn < 16; ++turn) {
        const double angle = 6.283185307179586 * turn / 16;
        const Vec3d along(std::cos(angle), std::sin(angle), 0);
        const Vec3d aside(-std::sin(angle), std::cos(angle), 0);
        const ShearedRay ray({.origin = {0, 0, 1}, .direction = {0, 0, -1}});
        const Vec3d up = aside + Vec3d(0, 0, 0.5), down = aside - Vec3d(0, 0, 0.5);
        const int count = crossing<Vec3d>(ray, -along, along, up, 0, kInfinity).has_value() +
                          crossing<Vec3d>(ray, along, -along, down, 0, kInfinity).has_value();
        EXPECT_TRUE(count == 0 || count == 2) << turn;
        total += count;
    }
    EXPECT_GT(total, 0);
    EXPECT_LT(total, 32);
}

TEST(RayCrossing, triangles_seen_edge_on_are_not_crossed) {
    const ShearedRay ray({.origin = {0, 0, 1}, .direction = {0, 0, -1}});
    EXPECT_FALSE(crossing(ray, {-1, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0, kInfinity));
    EXPECT_FALSE(crossing(ray, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, 0, kInfinity));
    EXPECT_FALSE(crossing(ray, {0, 0, 0}, {0, 0, -1}, {1, 1, 0}, 0, kInfinity));
    EXPECT_FALSE(crossing(ray, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, kInfinity));
}

}  // namespace
}  // namespace boxwood
