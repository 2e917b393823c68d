// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/separation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laws/random.h"

namespace boxwood {
namespace {

const Box3d kCube = {Vec3d(0, 0, 0), Vec3d(1, 1, 1)};

TEST(BoxTriangle, touching_counts) {
    EXPECT_TRUE(overlap(kCube, {Vec3d(1, 1, 1), Vec3d(2, 1, 1), Vec3d(1, 2, 3)}));  // a corner
    EXPECT_TRUE(overlap(kCube, {Vec3d(2, 0, 0.5), Vec3d(0, 2, 0.5), Vec3d(2, 2, 0.5)}));  // an edge
    EXPECT_TRUE(overlap(kCube, {Vec3d(1, 0, 0), Vec3d(1, 5, 0), Vec3d(1, 0, 5)}));        // a face
    EXPECT_FALSE(overlap(kCube, {Vec3d(2, 0.1, 0.5), Vec3d(0.1, 2, 0.5), Vec3d(2, 2, 0.5)}));
    EXPECT_FALSE(
        overlap(kCube, {Vec3d(std::nextafter(1, 2), 0, 0), Vec3d(2, 1, 0), Vec3d(2, 0, 1)}));
}

TEST(BoxTriangle, one_may_hold_the_other) {
    EXPECT_TRUE(overlap(kCube, {Vec3d(0.4, 0.5, 0.5), Vec3d(0.5, 0.4, 0.5), Vec3d(0.5, 0.5, 0.6)}));
    EXPECT_TRUE(overlap(kCube, {Vec3d(-9, -9, 0.5), Vec3d(9, -9, 0.5), Vec3d(0, 20, 0.5)}));
    const double infinity = std::numeric_limits<double>::infinity();
    const Box3d all = {Vec3d::Constant(-infinity), Vec3d::Constant(infinity)};
    EXPECT_TRUE(overlap(all, {Vec3d(1e30, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}));
    EXPECT_FALSE(overlap(Box3d(), {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}));
}

TEST(BoxTriangle, zero_area_is_a_segment_or_a_point) {
    const Vec3d a(0.5, 0.5, 0.5), b(5, 5, 5), beside(1.4, 0.5, 0.5), c(0.5, 1.4, 0.5);
    EXPECT_TRUE(overlap(kCube, {a, a, a}));
    EXPECT_TRUE(overlap(kCube, {b, a, b}));
    EXPECT_FALSE(overlap(kCube, {b, b, b}));
    EXPECT_TRUE(overlap(kCube, {beside, c, c}));
    EXPECT_FALSE(
        overlap(kCube, {Vec3d(2.2, 0.5, 0.5), Vec3d(0.5, 2.2, 0.5), Vec3d(0.5, 2.2, 0.5)}));
}

/// Whether some point of many on the triangle is in the box, or some point of the box's is near it.
bool some_point_is_inside(const Box3d& box, const TriangleCorners& t) {
    constexpr int kSteps = 60;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
            const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
            const Vec3d p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
            if ((p.array() >= box.lo.array()).all() && (p.array() <= box.hi.array()).all())
                return true;
        }
    }
    return false;
}

TEST(BoxTriangle, agrees_with_many_points_of_the_triangle) {
    Random random(1);
    int touching = 0;
    for (int i = 0; i < 3000; ++i) {
        const TriangleCorners t = {random.point(-1, 2), random.point(-1, 2), random.point(-1, 2)};
        const Vec3d center = random.point(0, 1);
        const auto box = [&](double size) -> Box3d {
            return {center - Vec3d::Constant(size), center + Vec3d::Constant(size)};
        };
        // A box a bit larger than the points' distance holds one of them if the triangle touches.
        touching += overlap(box(0.3), t);
        ASSERT_LE(some_point_is_inside(box(0.3), t), overlap(box(0.3), t)) << i;
        ASSERT_LE(overlap(box(0.3), t), some_point_is_inside(box(0.36), t)) << i;
    }
    EXPECT_GT(touching, 300);
    EXPECT_LT(touching, 2700);
}

TEST(TriangleTriangle, touching_counts) {
    const TriangleCorners t = {Vec3d(0, 0, 0), Vec3d(4, 0, 0), Vec3d(0, 4, 0)};
    EXPECT_TRUE(overlap(t, t));
    EXPECT_TRUE(overlap(t, {Vec3d(1, 1, 0), Vec3d(1, 1, 5), Vec3d(2, 1, 5)}));     // a corner
    EXPECT_TRUE(overlap(t, {Vec3d(1, 1, -1), Vec3d(1, 1, 5), Vec3d(2, 1, 5)}));    // through it
    EXPECT_TRUE(overlap(t, {Vec3d(2, -1, -1), Vec3d(2, 1, 1), Vec3d(2, -1, 1)}));  // an edge
    EXPECT_TRUE(overlap(t, {Vec3d(1, 1, 0), Vec3d(2, 1, 0), Vec3d(1, 2, 0)}));     // in its plane
    EXPECT_FALSE(overlap(t, {Vec3d(4, 4, 0), Vec3d(2.1, 2, 0), Vec3d(4, 3, 0)}));
    EXPECT_FALSE(overlap(t, {Vec3d(1, 1, 1e-9), Vec3d(1, 1, 5), Vec3d(2, 1, 5)}));
    EXPECT_FALSE(overlap(t, {Vec3d(2.1, 2.1, -1), Vec3d(2.1, 2.1, 5), Vec3d(5, 5, 0)}));
}

TEST(TriangleTriangle, zero_area_is_a_segment_or_a_point) {
    const TriangleCorners t = {Vec3d(0, 0, 0), Vec3d(4, 0, 0), Vec3d(0, 4, 0)};
    const auto segment = [](const Vec3d& a, const Vec3d& b) { return TriangleCorners{a, b, b}; };
    const Vec3d inside(1, 1, 0), up(1, 1, 1), down(1, 1, -1), beside(3, 3, 0), far(3, 3, 5);
    EXPECT_TRUE(overlap(t, segment(inside, inside)));
    EXPECT_TRUE(overlap(t, segment(up, down)));
    EXPECT_TRUE(overlap(t, segment(inside, far)));
    EXPECT_FALSE(overlap(t, segment(up, far)));
    EXPECT_FALSE(overlap(t, segment(beside, beside)));
    EXPECT_FALSE(overlap(t, segment(beside, far)));
    EXPECT_TRUE(overlap(segment(up, down), segment(inside, beside)));
    EXPECT_FALSE(overlap(segment(up, inside), segment(beside, far)));
    EXPECT_FALSE(overlap(segment({0, 0, 0}, {1, 1, 1}), segment({0.5, 0.5, 0.6}, {1, 1, 1.1})));
    EXPECT_TRUE(overlap(segment({0, 0, 0}, {1, 1, 1}), segment({0.5, 0.5, 0.5}, {3, 3, 3})));
    EXPECT_FALSE(overlap(segment({0, 0, 0}, {1, 1, 1}), segment({1.5, 1.5, 1.5}, {3, 3, 3})));
    EXPECT_FALSE(overlap(segment({0, 0, 0}, {2, 1, 3}), segment({1, 0.5, 1.4}, {1, 0.5, 1.4})));
}

/// By another way: in one plane they may touch without an edge of one through the other.
bool some_edge_goes_through(const TriangleCorners& edges, const TriangleCorners& t) {
    const Vec3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d &p = edges[k], &q = edges[(k + 1) % 3];
        const double at_p = normal.dot(p - t[0]), at_q = normal.dot(q - t[0]);
        if ((at_p > 0) == (at_q > 0)) continue;
        const Vec3d x = p + at_p / (at_p - at_q) * (q - p);
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i)
            inside = inside && normal.cross(t[(i + 1) % 3] - t[i]).dot(x - t[i]) >= 0;
        if (inside) return true;
    }
    return false;
}

TEST(TriangleTriangle, touch_when_an_edge_of_one_goes_through_the_other) {
    Random random(2);
    int touching = 0;
    for (int i = 0; i < 20'000; ++i) {
        const TriangleCorners a = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const TriangleCorners b = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const bool expected = some_edge_goes_through(a, b) || some_edge_goes_through(b, a);
        ASSERT_EQ(overlap(a, b), expected) << i;
        ASSERT_EQ(overlap(b, a), expected) << i;
        touching += expected;
    }
    EXPECT_GT(touching, 2000);
    EXPECT_LT(touching, 18'000);
}

}  // namespace
}  // namespace boxwood
