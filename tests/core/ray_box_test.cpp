// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/ray_box.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "boxwood/core/round_outward.h"
#include "laws/random.h"

namespace boxwood {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Box3f kUnit = {Vec3f::Zero(), Vec3f::Ones()};

double entry(const Box3f& box, const Ray& ray) {
    return SlabRay(ray, box).intersect(box, ray.t_min, ray.t_max);
}
bool is_hit(const Box3f& box, const Ray& ray) { return entry(box, ray) != SlabRay::kMiss; }

TEST(RayBox, entry_is_where_the_ray_enters) {
    EXPECT_NEAR(entry(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}}), 2, 1e-12);
    EXPECT_NEAR(entry(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -4}}), 0.5, 1e-12);
    EXPECT_NEAR(entry(kUnit, {.origin = {-1, -1, -1}, .direction = {1, 1, 1}}), 1, 1e-12);
}

TEST(RayBox, entry_is_never_later_than_the_ray_is_inside) {
    EXPECT_LE(entry(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}}), 2);
}

TEST(RayBox, rays_that_start_inside_enter_at_t_min) {
    EXPECT_EQ(entry(kUnit, {.origin = {0.5, 0.5, 0.5}, .direction = {1, 2, 3}}), 0);
    EXPECT_EQ(entry(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}, .t_min = 2.5}), 2.5);
}

TEST(RayBox, boxes_behind_or_beyond_the_limits_are_missed) {
    EXPECT_FALSE(is_hit(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, 1}}));
    EXPECT_FALSE(is_hit(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}, .t_max = 1.9}));
    EXPECT_FALSE(is_hit(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}, .t_min = 3.1}));
    EXPECT_TRUE(
        is_hit(kUnit, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, 1}, .t_min = -kInfinity}));
}

TEST(RayBox, zero_components_of_the_direction_are_right_on_all_axes_and_signs) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double zero : {0.0, -0.0}) {
            for (const double way : {1.0, -1.0}) {
                Ray ray;
                ray.direction = Vec3d::Constant(zero);
                ray.direction[axis] = way;
                // Inside the slabs of the other two axes, on their faces, and outside.
                for (const double place : {0.0, 0.5, 1.0}) {
                    ray.origin = Vec3d::Constant(place);
                    ray.origin[axis] = 0.5 - 2 * way;
                    EXPECT_TRUE(is_hit(kUnit, ray)) << axis << zero << way << place;
                }
                for (const double place : {-0.001, 1.001, -1e6, 1e6}) {
                    ray.origin[(axis + 1) % 3] = place;
                    EXPECT_FALSE(is_hit(kUnit, ray)) << axis << zero << way << place;
                }
            }
        }
    }
}

TEST(RayBox, components_too_small_to_invert_count_as_zero) {
    for (const double tiny : {5e-324, -5e-324, 1e-310, -1e-300}) {
        EXPECT_TRUE(is_hit(kUnit, {.origin = {0, 0.5, 3}, .direction = {tiny, 0, -1}})) << tiny;
        EXPECT_TRUE(is_hit(kUnit, {.origin = {1, 0.5, 3}, .direction = {tiny, 0, -1}})) << tiny;
        EXPECT_FALSE(is_hit(kUnit, {.origin = {2, 0.5, 3}, .direction = {tiny, 0, -1}})) << tiny;
    }
}

TEST(RayBox, origin_on_a_face_hits_in_every_direction) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        Vec3d origin = random.point(0, 1);
        const auto axis = static_cast<int>(random.index(3));
        origin[axis] = std::floor(random.number(0, 2));
        Ray ray = {.origin = origin, .direction = random.direction()};
        EXPECT_EQ(entry(kUnit, ray), 0) << i;
        ray.direction[axis] = 0;  // within the face
        EXPECT_EQ(entry(kUnit, ray), 0) << i;
    }
}

TEST(RayBox, edges_and_corners_belong_to_it) {
    EXPECT_TRUE(is_hit(kUnit, {.origin = {2, 0, 1}, .direction = {-1, 0, 0}}));
    EXPECT_TRUE(is_hit(kUnit, {.origin = {2, 0, 2}, .direction = {-1, 1, -1}}));
    EXPECT_TRUE(is_hit(kUnit, {.origin = {0, 2, 0.5}, .direction = {1, -1, 0}}));
}

TEST(RayBox, flat_and_point_boxes_are_hit) {
    const Box3f flat = {Vec3f(0, 0, 0.5f), Vec3f(1, 1, 0.5f)};
    EXPECT_TRUE(is_hit(flat, {.origin = {0.5, 0.5, 3}, .direction = {0, 0, -1}}));
    EXPECT_TRUE(is_hit(flat, {.origin = {-1, 0.5, 0.5}, .direction = {1, 0, 0}}));
    EXPECT_FALSE(is_hit(flat, {.origin = {-1, 0.5, 0.6}, .direction = {1, 0, 0}}));
    const Box3f point = {Vec3f::Ones(), Vec3f::Ones()};
    EXPECT_TRUE(is_hit(point, {.origin = {3, 4, 5}, .direction = {-2, -3, -4}}));
    EXPECT_FALSE(is_hit(point, {.origin = {3, 4, 5}, .direction = {-2, -3, -4.001}}));
}

TEST(RayBox, empty_boxes_are_missed) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        Ray ray = {.origin = random.point(-1, 1), .direction = random.direction()};
        ray.direction[static_cast<int>(random.index(3))] *= std::floor(random.number(0, 2));
        ray.t_min = -kInfinity;
        ASSERT_EQ(SlabRay(ray, kUnit).intersect(Box3f{}, ray.t_min, ray.t_max), SlabRay::kMiss);
    }
}

TEST(RayBox, largest_box_is_hit) {
    const Box3f all = {Vec3f::Constant(-FLT_MAX), Vec3f::Constant(FLT_MAX)};
    EXPECT_EQ(entry(all, {.origin = {1, 2, 3}, .direction = {1e140, 0, 0}}), 0);
    EXPECT_TRUE(is_hit(all, {.origin = {1e39, 0, 0}, .direction = {-1, 0, 0}}));
    EXPECT_FALSE(is_hit(all, {.origin = {1e39, 0, 0}, .direction = {1, 0, 0}}));
}

/// Rays at a point of the box, from near and far: rounding must never lose it.
TEST(RayBox, box_of_a_point_on_the_ray_is_never_missed) {
    constexpr std::uint64_t kSeed = 3;
    Random random(kSeed);
    for (int i = 0; i < 100'000; ++i) {
        const double scale = std::pow(10, random.number(-8, 8));
        const Vec3d target = scale * random.point(-1, 1);
        Vec3d origin = std::pow(10, random.number(-8, 8)) * random.point(-1, 1);
        if (i % 3 == 0) origin[i / 3 % 3] = target[i / 3 % 3];
        Box3d box;
        box.extend(target);
        if (i % 2) box.extend(target + 1e-3 * scale * random.point(-1, 1));
        const Ray ray = {.origin = origin, .direction = target - origin};
        if (!is_traceable(ray)) continue;
        ASSERT_TRUE(is_hit(rounded_outward(box), ray)) << "seed " << kSeed << ", ray " << i;
    }
}

/// Not much larger than it is, either.
TEST(RayBox, rays_that_pass_by_at_a_millionth_miss) {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3d origin = random.point(-5, 5), direction = random.direction();
        const Ray ray = {.origin = origin, .direction = direction};
        const Vec3d nearest = origin + random.number(0, 5) * direction;
        const Vec3d beside = nearest + 1e-6 * direction.cross(random.direction()).normalized();
        const Box3f box = rounded_outward({beside, beside});
        const double distance = (box.centroid().cast<double>() - origin).cross(direction).norm();
        if (distance < 1.1e-6) continue;  // float has moved it
        EXPECT_FALSE(is_hit(box, ray) && box.extent().maxCoeff() == 0) << i;
    }
}

}  // namespace
}  // namespace boxwood
