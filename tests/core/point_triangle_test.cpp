// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/point_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laws/point_triangle_oracle.h"
#include "laws/random.h"

namespace boxwood {
namespace {

const Vec3d kA(0, 0, 0), kB(4, 0, 0), kC(0, 4, 0);

TEST(PointTriangle, finds_each_part_of_a_triangle) {
    struct Case {
        Vec3d point;
        TrianglePart part;
        Vec3d nearest;
    };
    const Case cases[] = {
        {{1, 1, 3}, TrianglePart::face, {1, 1, 0}},
        {{1, 1, -2}, TrianglePart::face, {1, 1, 0}},
        {{1, 1, 0}, TrianglePart::face, {1, 1, 0}},
        {{2, -1, 1}, TrianglePart::edge_ab, {2, 0, 0}},
        {{3, 3, 1}, TrianglePart::edge_bc, {2, 2, 0}},
        {{-3, 1, 0}, TrianglePart::edge_ca, {0, 1, 0}},
        {{2, 0, 0}, TrianglePart::edge_ab, {2, 0, 0}},
        {{-1, -1, 5}, TrianglePart::corner_a, {0, 0, 0}},
        {{9, 0, 0}, TrianglePart::corner_b, {4, 0, 0}},
        {{-1, 5, 2}, TrianglePart::corner_c, {0, 4, 0}},
        {{4, 0, 0}, TrianglePart::corner_b, {4, 0, 0}},
    };
    for (const auto& [point, part, nearest] : cases) {
        const PlaceOnTriangle place = nearest_place(point, kA, kB, kC);
        EXPECT_EQ(place.part, part) << point.transpose();
        EXPECT_EQ(place.squared_distance, (point - nearest).squaredNorm()) << point.transpose();
        EXPECT_EQ(place_at(place, kA, kB, kC), nearest) << point.transpose();
        const Vec3d at = (1 - place.u - place.v) * kA + place.u * kB + place.v * kC;
        EXPECT_EQ(at, nearest) << point.transpose();
    }
}

TEST(PointTriangle, one_of_zero_area_is_the_segment_or_point_that_it_covers) {
    const Vec3d a(1, 2, 3), b(4, 2, 3), middle(2, 2, 3), above(2, 5, 3);
    EXPECT_EQ(nearest_place(above, a, a, a).squared_distance, 10);
    EXPECT_EQ(nearest_place(a, a, a, a).squared_distance, 0);
    for (const auto& [p, q, r] : {std::tuple(a, a, b), std::tuple(a, b, a), std::tuple(b, a, a),
                                  std::tuple(a, b, middle), std::tuple(middle, a, b)}) {
        const PlaceOnTriangle place = nearest_place(above, p, q, r);
        EXPECT_EQ(place.squared_distance, 9);
        EXPECT_NE(place.part, TrianglePart::face);
        EXPECT_NEAR((place_at(place, p, q, r) - middle).norm(), 0, 1e-15);
    }
}

TEST(PointTriangle, an_edge_is_as_far_from_either_side) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3d a = random.point(-1, 1), b = random.point(-1, 1), point = random.point(-3, 3);
        const PlaceOnSegment forth = nearest_place(point, a, b), back = nearest_place(point, b, a);
        ASSERT_EQ(forth.squared_distance, back.squared_distance) << i;
    }
}

/// Of size 1, with a third corner that far from the first edge, at any place along it.
void check_thin_triangles(double width, double tolerance) {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3d a = random.point(-1, 1), along = random.direction();
        const Vec3d b = a + along;
        const Vec3d c = a + random.number(-0.2, 1.2) * along + width * random.direction();
        const double s = random.number(), t = random.number(0, 1 - s);
        const Vec3d inside = a + s * (b - a) + t * (c - a);
        const Vec3d point =
            inside + std::ldexp(1.0, -static_cast<int>(random.index(50))) * random.direction();
        const double expected = static_cast<double>(distance_in_long_double(point, a, b, c));
        for (const auto& [p, q, r] :
             {std::tuple(a, b, c), std::tuple(b, c, a), std::tuple(c, b, a)}) {
            const double found = std::sqrt(nearest_place(point, p, q, r).squared_distance);
            ASSERT_NEAR(found, expected, tolerance) << i << " of width " << width;
        }
    }
}

TEST(PointTriangle, is_as_near_as_long_double_finds) {
    for (const double width : {1.0, 1e-2, 1e-4}) check_thin_triangles(width, 1e-12);
}
TEST(PointTriangle, slivers_are_right_to_eight_digits) {
    for (const double width : {1e-6, 1e-7, 1e-8, 1e-9, 1e-12, 1e-15})
        check_thin_triangles(width, 1e-8);
}

}  // namespace
}  // namespace boxwood
