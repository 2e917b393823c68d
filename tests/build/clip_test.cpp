// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boxwood/mesh/triangle_mesh.h"
#include "laws/random.h"

namespace boxwood {
namespace {

WideBox wide(const Box3f& box) { return Reference(box, 0).box(); }

TriangleMesh triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return {.vertices = {a, b, c}, .faces = {{0, 1, 2}}};
}

TEST(Clip, part_of_a_triangle_has_a_box_as_small_as_rounding_allows) {
    const TriangleMesh mesh = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 8});
    const Box3f all = triangle_boxes(mesh)[0];
    const Box3f left = clipped_box(mesh, 0, wide(all), 0, 0, 1).box();
    EXPECT_EQ(left.lo, Vec3f(0, 0, 0));
    EXPECT_EQ(left.hi, Vec3f(1, 4, 8));
    const Box3f right = clipped_box(mesh, 0, wide(all), 0, 1, 4).box();
    EXPECT_EQ(right.lo, Vec3f(1, 0, 0));
    EXPECT_EQ(right.hi.x(), 4);
    EXPECT_NEAR(right.hi.y(), 3, 1e-5);
    EXPECT_NEAR(right.hi.z(), 6, 1e-5);
    EXPECT_GE(right.hi.y(), 3);
    const Box3f middle = clipped_box(mesh, 0, wide(all), 1, 1, 2).box();
    EXPECT_NEAR(middle.lo.z(), 2, 1e-5);
    EXPECT_NEAR(middle.hi.z(), 4, 1e-5);
    EXPECT_NEAR(middle.hi.x(), 3, 1e-5);
}

TEST(Clip, box_without_a_point_of_the_triangle_is_empty) {
    const TriangleMesh mesh = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    Box3f corner{Vec3f(3, 3, 0), Vec3f(4, 4, 0)};
    EXPECT_TRUE(clipped_box(mesh, 0, wide(corner), 0, 3, 3.5).is_empty());
    EXPECT_TRUE(clipped_box(mesh, 0, wide(corner), 0, 5, 6).is_empty());
}

TEST(Clip, flat_triangles_keep_flat_boxes) {
    const TriangleMesh mesh = triangle({0.1, 0, 0}, {0.1, 5, 1}, {0.1, 1, 7});
    const Box3f all = triangle_boxes(mesh)[0];
    const Box3f part = clipped_box(mesh, 0, wide(all), 1, 1, 2).box();
    EXPECT_EQ(part.lo.x(), all.lo.x());
    EXPECT_EQ(part.hi.x(), all.hi.x());
}

/// Cuts at random places, again and again; every point of the triangle must be in some part.
TEST(Clip, no_point_is_lost) {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const double scale = std::pow(10.0, random.number(-35, 31));
        const Vec3d offset = random.number() < 0.5 ? Vec3d(Vec3d::Zero()) : random.point(-1e6, 1e6);
        const auto corner = [&]() -> Vec3d { return scale * (random.point(-1, 1) + offset); };
        const TriangleMesh mesh = triangle(corner(), corner(), corner());
        std::vector<WideBox> parts = {wide(triangle_boxes(mesh)[0])};
        for (int cut = 0; cut < 8; ++cut) {
            const WideBox whole = parts[random.index(parts.size())];
            const int axis = static_cast<int>(random.index(3));
            const float from = whole.lo[axis], to = whole.hi[axis];
            const float plane =
                std::clamp(from + static_cast<float>(random.number()) * (to - from), from, to);
            std::vector<WideBox> rest;
            for (const WideBox& part : parts) {
                if (part.lo.matrix() != whole.lo.matrix() || part.hi.matrix() != whole.hi.matrix())
                    rest.push_back(part);
            }
            for (const WideBox& half : {clipped_box(mesh, 0, whole, axis, from, plane),
                                        clipped_box(mesh, 0, whole, axis, plane, to)}) {
                if (!half.is_empty()) rest.push_back(half);
            }
            parts = rest;
        }
        const MeshView view = mesh;
        for (int sample = 0; sample < 60; ++sample) {
            double u = random.number(), v = random.number();
            if (u + v > 1) u = 1 - u, v = 1 - v;
            if (sample < 3) u = sample == 1, v = sample == 2;
            // In more digits than double has, as the point must be in the triangle.
            using Point = Eigen::Matrix<long double, 3, 1>;
            const Point a = view.corner(0, 0).cast<long double>();
            const Point point = a + u * (view.corner(0, 1).cast<long double>() - a) +
                                v * (view.corner(0, 2).cast<long double>() - a);
            EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const WideBox& part) {
                return (part.lo.head<3>().cast<long double>() <= point.array()).all() &&
                       (point.array() <= part.hi.head<3>().cast<long double>()).all();
            })) << point.transpose();
        }
    }
}

}  // namespace
}  // namespace boxwood
