// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/ray_triangle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "laws/random.h"

namespace boxwood {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Triangle {
    Vec3d a, b, c;
};

const Triangle kUnit = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

std::optional<TriangleHit> hit(const Triangle& triangle, const Ray& ray) {
    return intersect(ShearedRay(ray), triangle.a, triangle.b, triangle.c, ray.t_min, ray.t_max);
}

/// Straight down from z = 2.
Ray down(double x, double y) { return {.origin = {x, y, 2}, .direction = {0, 0, -1}}; }

TEST(RayTriangle, hit_has_distance_and_barycentric_coordinates) {
    const auto found = hit(kUnit, down(0.25, 0.5));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->t, 2);
    EXPECT_EQ(found->u, 0.25);
    EXPECT_EQ(found->v, 0.5);
}

TEST(RayTriangle, likely_hits_are_the_same_to_the_last_bit) {
    const auto bits_of_all = [](const std::optional<TriangleHit>& hit) {
        std::array<std::uint64_t, 3> bits = {};
        if (hit) std::memcpy(bits.data(), &hit->t, sizeof bits);
        return bits;
    };
    Random random(7);
    int hits = 0;
    for (int i = 0; i < 200'000; ++i) {
        // Down to where products of coordinates lose digits, some aimed at corners and edges.
        const double scale = std::ldexp(1.0, -static_cast<int>(random.index(600)) * (i % 2));
        Triangle triangle;
        for (Vec3d* corner : {&triangle.a, &triangle.b, &triangle.c})
            *corner = scale * random.point(-1, 1).array().round().matrix() +
                      (i % 3 ? scale : 0.0) * random.point(-1, 1);
        if (i % 1000 == 1) triangle.b.y() = std::nan("");
        if (i % 1000 == 2) triangle.c.x() = kInfinity;
        const Vec3d aim = i % 5 == 0   ? triangle.a
                          : i % 5 == 1 ? Vec3d(0.5 * triangle.a + 0.5 * triangle.b)
                                       : Vec3d(scale * random.point(-0.3, 0.3));
        const Vec3d origin = scale * random.point(-3, 3);
        const Ray ray = {.origin = origin, .direction = (aim - origin) / scale};
        if (!is_traceable(ray)) continue;
        const ShearedRay sheared(ray);
        const auto& [a, b, c] = triangle;
        const auto expected = intersect(sheared, a, b, c, ray.t_min, ray.t_max);
        const auto found = intersect_likely(sheared, a, b, c, ray.t_min, ray.t_max);
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        ASSERT_EQ(bits_of_all(found), bits_of_all(expected)) << i;
        if (found) ASSERT_EQ(found->from_front, expected->from_front) << i;
        hits += found.has_value();
    }
    EXPECT_GT(hits, 10'000);
}

TEST(RayTriangle, corners_are_at_u_and_v_of_0_and_1) {
    const auto at_a = hit(kUnit, down(0, 0)), at_b = hit(kUnit, down(1, 0)),
               at_c = hit(kUnit, down(0, 1));
    ASSERT_TRUE(at_a && at_b && at_c);
    EXPECT_EQ(std::pair(at_a->u, at_a->v), std::pair(0.0, 0.0));
    EXPECT_EQ(std::pair(at_b->u, at_b->v), std::pair(1.0, 0.0));
    EXPECT_EQ(std::pair(at_c->u, at_c->v), std::pair(0.0, 1.0));
}

TEST(RayTriangle, both_sides_are_hit_alike) {
    const auto front = hit(kUnit, down(0.25, 0.5));
    const auto back = hit(kUnit, {.origin = {0.25, 0.5, -2}, .direction = {0, 0, 1}});
    const auto turned = hit({kUnit.a, kUnit.c, kUnit.b}, down(0.25, 0.5));
    ASSERT_TRUE(front && back && turned);
    EXPECT_EQ(back->t, front->t);
    EXPECT_EQ(back->u, front->u);
    EXPECT_EQ(turned->u, front->v);
    EXPECT_EQ(turned->v, front->u);
}

TEST(RayTriangle, edges_and_vertices_belong_to_it_and_nothing_beyond) {
    const double below_0 = -1e-300, above_1 = std::nextafter(1.0, 2.0);
    for (const Ray& ray : {down(0, 0), down(1, 0), down(0, 1), down(0.5, 0), down(0, 0.5),
                           down(0.5, 0.5), down(0.125, 0.875)})
        EXPECT_TRUE(hit(kUnit, ray)) << ray.origin.transpose();
    for (const Ray& ray : {down(below_0, 0.5), down(0.5, below_0), down(above_1, 0),
                           down(0, above_1), down(0.5, std::nextafter(0.5, 1.0)), down(-1, -1)})
        EXPECT_FALSE(hit(kUnit, ray)) << ray.origin.transpose();
}

TEST(RayTriangle, distance_counts_in_lengths_of_the_direction) {
    Ray ray = down(0.25, 0.25);
    for (const double length : {1e-140, 1e-3, 4.0, 1e140}) {
        ray.direction = {0, 0, -length};
        const auto found = hit(kUnit, ray);
        ASSERT_TRUE(found) << length;
        EXPECT_NEAR(found->t * length, 2, 1e-12);
    }
}

TEST(RayTriangle, limits_of_t_are_inclusive) {
    const auto with_limits = [](double t_min, double t_max) {
        Ray ray = down(0.25, 0.25);
        ray.t_min = t_min;
        ray.t_max = t_max;
        return hit(kUnit, ray).has_value();
    };
    EXPECT_TRUE(with_limits(2, 2));
    EXPECT_TRUE(with_limits(0, 2));
    EXPECT_TRUE(with_limits(2, kInfinity));
    EXPECT_FALSE(with_limits(0, std::nextafter(2.0, 0.0)));
    EXPECT_FALSE(with_limits(std::nextafter(2.0, 3.0), kInfinity));
    EXPECT_FALSE(with_limits(-kInfinity, 1));
}

TEST(RayTriangle, what_lies_behind_is_hit_only_with_negative_t_min) {
    Ray ray = {.origin = {0.25, 0.25, -1}, .direction = {0, 0, -1}};
    EXPECT_FALSE(hit(kUnit, ray));
    ray.t_min = -kInfinity;
    ASSERT_TRUE(hit(kUnit, ray));
    EXPECT_EQ(hit(kUnit, ray)->t, -1);
}

TEST(RayTriangle, origin_on_the_triangle_hits_at_0) {
    const auto found = hit(kUnit, {.origin = {0.25, 0.25, 0}, .direction = {1, 2, 3}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->t, 0);
}

TEST(RayTriangle, parallel_rays_miss) {
    EXPECT_FALSE(hit(kUnit, {.origin = {-1, 0.25, 1}, .direction = {1, 0, 0}}));
    EXPECT_FALSE(hit(kUnit, {.origin = {-1, -1, 1e-9}, .direction = {1, 1, 0}}));
}

TEST(RayTriangle, rays_along_an_axis_in_its_plane_miss) {
    EXPECT_FALSE(hit(kUnit, {.origin = {-1, 0.25, 0}, .direction = {1, 0, 0}}));
    EXPECT_FALSE(hit(kUnit, {.origin = {-1, 0, 0}, .direction = {1, 0, 0}}));
    EXPECT_FALSE(hit(kUnit, {.origin = {0, 3, 0}, .direction = {0, -1, 0}}));
}

TEST(RayTriangle, points_and_segments_are_missed_along_an_axis) {
    const Vec3d p(0.5, 0.5, 0), q(0.25, 0.25, 0);
    EXPECT_FALSE(hit({p, p, p}, down(0.5, 0.5)));
    EXPECT_FALSE(hit({p, q, p}, down(0.5, 0.5)));
    EXPECT_FALSE(hit({p, q, q}, down(0.375, 0.375)));
    EXPECT_FALSE(hit({p, q, Vec3d::Zero()}, down(0.375, 0.375)));
}

TEST(RayTriangle, coordinates_that_are_not_finite_are_missed) {
    for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
        for (int corner = 0; corner < 3; ++corner) {
            for (int k = 0; k < 3; ++k) {
                Triangle triangle = kUnit;
                (corner == 0 ? triangle.a : corner == 1 ? triangle.b : triangle.c)[k] = bad;
                const auto found = hit(triangle, down(0.25, 0.25));
                EXPECT_FALSE(found) << bad << corner << k;
            }
        }
    }
}

/// Moeller and Trumbore's test in long double.
struct LongHit {
    long double t, u, v;
};
LongHit moeller_trumbore(const Triangle& triangle, const Ray& ray) {
    using Vec = Eigen::Matrix<long double, 3, 1>;
    const Vec a = triangle.a.cast<long double>();
    const Vec ab = triangle.b.cast<long double>() - a, ac = triangle.c.cast<long double>() - a;
    const Vec d = ray.direction.cast<long double>(), ao = ray.origin.cast<long double>() - a;
    const Vec p = d.cross(ac);
    const long double determinant = ab.dot(p);
    const Vec q = ao.cross(ab);
    return {ac.dot(q) / determinant, ao.dot(p) / determinant, d.dot(q) / determinant};
}

TEST(RayTriangle, agrees_with_moeller_trumbore_in_long_double) {
    constexpr std::uint64_t kSeed = 5;
    Random random(kSeed);
    int hits = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Triangle triangle = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const Ray ray = {.origin = random.point(-2, 2),
                         .direction = random.point(-0.5, 0.5) - random.point(-2, 2)};
        const auto [t, u, v] = moeller_trumbore(triangle, ray);
        const long double from_edge = std::min({u, v, 1 - u - v});
        // Too near to an edge or to being parallel to tell.
        if (std::abs(from_edge) < 1e-6L || std::abs(t) < 1e-6L) continue;
        const Vec3d normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
        if (std::abs(normal.normalized().dot(ray.direction.normalized())) < 1e-3) continue;

        const bool expected = from_edge > 0 && t > 0;
        const auto found = hit(triangle, ray);
        ASSERT_EQ(found.has_value(), expected) << "seed " << kSeed << ", pair " << i;
        if (!found) continue;
        ++hits;
        EXPECT_NEAR(found->t, static_cast<double>(t), 1e-10 * (1 + std::abs(found->t)));
        EXPECT_NEAR(found->u, static_cast<double>(u), 1e-9);
        EXPECT_NEAR(found->v, static_cast<double>(v), 1e-9);
    }
    EXPECT_GT(hits, 1000);
}

TEST(RayTriangle, two_that_share_an_edge_leave_no_gap) {
    Random random(6);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3d a = random.point(-1, 1), b = random.point(-1, 1);
        const Ray ray = {
            .origin = random.point(4, 5),
            .direction = a + random.number(0.05, 0.95) * (b - a) - Vec3d(4.5, 4.5, 4.5)};
        const Vec3d target = ray.at(1), along = (b - a).normalized();
        // Wings to both sides of the edge, as the ray sees it.
        const Vec3d side = along.cross(ray.direction).normalized();
        const Vec3d c = target + 2 * side, d = target - 2 * side;
        const Vec3d moved_a = target - along, moved_b = target + along;
        ASSERT_TRUE(hit({moved_a, moved_b, c}, ray) || hit({moved_b, moved_a, d}, ray)) << i;
    }
}

int sign(__int128 x) { return (x > 0) - (x < 0); }
int sign(double x) { return (x > 0) - (x < 0); }

TEST(DifferenceOfProducts, sign_is_exact) {
    Random random(7);
    const auto whole = [&] { return std::floor(random.number(-0x1p52, 0x1p52)); };
    const auto exact = [](double a, double b) {
        return static_cast<__int128>(a) * static_cast<__int128>(b);
    };
    for (int i = 0; i < 50'000; ++i) {
        const double a = whole(), b = whole();
        // Products that agree in nearly all their digits.
        const double c = a + std::floor(random.number(-2, 3)),
                     d = b + std::floor(random.number(-2, 3));
        ASSERT_EQ(sign(difference_of_products(a, b, c, d)), sign(exact(a, b) - exact(c, d))) << i;
        ASSERT_EQ(difference_of_products(a, b, a, b), 0);
        ASSERT_EQ(difference_of_products(a, b, b, a), 0);
        const double e = whole(), f = whole();
        ASSERT_EQ(sign(difference_of_products(a, b, e, f)), sign(exact(a, b) - exact(e, f))) << i;
        ASSERT_EQ(sign(difference_of_products(c, d, a, b)), sign(exact(c, d) - exact(a, b))) << i;
    }
}

TEST(DifferenceOfProducts, error_is_below_two_units_in_the_last_place) {
    Random random(8);
    for (int i = 0; i < 50'000; ++i) {
        const auto whole = [&] { return std::floor(random.number(-0x1p52, 0x1p52)); };
        const double a = whole(), b = whole(), c = a + std::floor(random.number(-9, 9)), d = b + 1;
        const __int128 exact = static_cast<__int128>(a) * static_cast<__int128>(b) -
                               static_cast<__int128>(c) * static_cast<__int128>(d);
        const double found = difference_of_products(a, b, c, d);
        EXPECT_NEAR(found, static_cast<double>(exact), 2 * 0x1p-52 * std::abs(found)) << i;
    }
}

}  // namespace
}  // namespace boxwood
