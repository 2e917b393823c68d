// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/ray_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laws/random.h"

namespace boxwood {
namespace {

std::optional<double> hit(const Ray& ray, bool starts_on_surface = false) {
    return intersect_sphere(ray, Vec3d(0, 0, -5), 1, starts_on_surface);
}

TEST(RaySphere, near_side_is_hit_first) {
    EXPECT_DOUBLE_EQ(hit({}).value(), 4);
    EXPECT_DOUBLE_EQ(hit({.direction = {0, 0, -2}}).value(), 2);
}

TEST(RaySphere, far_side_is_hit_from_inside_or_past_t_min) {
    EXPECT_DOUBLE_EQ(hit({.origin = {0, 0, -5}}).value(), 1);
    EXPECT_DOUBLE_EQ(hit({.t_min = 4.5}).value(), 6);
}

TEST(RaySphere, spheres_beside_behind_and_beyond_the_limits_are_missed) {
    EXPECT_FALSE(hit({.origin = {1.001, 0, 0}}));
    EXPECT_FALSE(hit({.direction = {0, 0, 1}}));
    EXPECT_FALSE(hit({.t_max = 3.9}));
    EXPECT_FALSE(hit({.t_min = 6.1}));
    EXPECT_FALSE(hit({.t_min = 4.1, .t_max = 5.9}));
}

TEST(RaySphere, limits_and_tangents_are_inclusive) {
    EXPECT_TRUE(hit({.t_max = 4}));
    EXPECT_TRUE(hit({.t_min = 6}));
    EXPECT_DOUBLE_EQ(hit({.origin = {1, 0, 0}}).value(), 5);
}

TEST(RaySphere, ray_from_the_surface_does_not_see_where_it_starts) {
    // Inwards it leaves on the other side, outwards it hits nothing.
    EXPECT_DOUBLE_EQ(hit({.origin = {0, 0, -4}}, true).value(), 2);
    EXPECT_FALSE(hit({.origin = {0, 0, -4}, .direction = {0, 0, 1}}, true));
    EXPECT_FALSE(hit({.origin = {0, 0, -4}, .direction = {1, 0, 0}}, true));
    EXPECT_FALSE(hit({.origin = {0, 0, -4}, .t_max = 1.9}, true));
}

TEST(RaySphere, found_points_lie_on_the_surface) {
    Random random(1);
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3d center = random.point(-1, 1);
        const double radius = std::pow(10, random.number(-4, 0));
        const Ray ray = {.origin = 100 * random.point(-1, 1),
                         .direction = center + 1.2 * radius * random.point(-1, 1) - Vec3d::Zero()};
        const Ray aimed = {.origin = ray.origin, .direction = ray.direction - ray.origin};
        const auto t = intersect_sphere(aimed, center, radius, false);
        const double off = (center - aimed.origin).cross(aimed.direction.normalized()).norm();
        if (std::abs(off - radius) < 1e-6 * radius) continue;
        ASSERT_EQ(t.has_value(), off < radius) << i;
        if (!t) continue;
        ++hits;
        // The digits of far small spheres are those of the distance.
        EXPECT_NEAR((aimed.at(*t) - center).norm(), radius, 1e-9 * radius + 1e-12) << i;
    }
    EXPECT_GT(hits, 5000);
}

TEST(RaySphere, small_far_spheres_keep_their_digits) {
    const Vec3d center(0, 0, -1e6);
    const auto t = intersect_sphere({.origin = {1e-4, 0, 0}}, center, 2e-4, false);
    ASSERT_TRUE(t);
    EXPECT_NEAR(*t, 1e6 - std::sqrt(3e-8), 1e-9);
    EXPECT_FALSE(intersect_sphere({.origin = {2.01e-4, 0, 0}}, center, 2e-4, false));
}

TEST(RaySphere, numbers_that_are_nan_miss) {
    const double nan = std::nan("");
    EXPECT_FALSE(intersect_sphere({}, Vec3d(0, nan, -5), 1, false));
    EXPECT_FALSE(intersect_sphere({}, Vec3d(0, 0, -5), nan, false));
    EXPECT_FALSE(intersect_sphere({}, Vec3d(0, nan, -5), 1, true));
}

}  // namespace
}  // namespace boxwood
