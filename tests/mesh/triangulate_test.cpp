// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "boxwood/core/random.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {
namespace {

TriangleMesh fan_of(std::vector<Vec3d> polygon) {
    TriangleMesh mesh{std::move(polygon), {}};
    for (int i = 1; i + 1 < static_cast<int>(mesh.vertices.size()); ++i)
        mesh.faces.emplace_back(0, i, i + 1);
    return mesh;
}

std::size_t mend(TriangleMesh& mesh) {
    const PolygonFan fans[] = {{0, static_cast<std::uint32_t>(mesh.vertices.size())}};
    return mend_fans(mesh.vertices, fans, mesh.faces);
}

/// The sum of the triangles' areas. Triangles of a polygon cover it without overlap exactly when
/// this is the polygon's own area.
double area(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Vec3i& f : mesh.faces)
        sum += (mesh.vertices[f[1]] - mesh.vertices[f[0]])
                   .cross(mesh.vertices[f[2]] - mesh.vertices[f[0]])
                   .norm() /
               2;
    return sum;
}

/// The polygon's area by Newell's sum.
double polygon_area(std::span<const Vec3d> polygon) {
    Vec3d sum = Vec3d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
    return sum.norm() / 2;
}

/// A star with so many spikes, in a plane that no axis is normal to.
std::vector<Vec3d> star(int spikes, double inner_radius) {
    const Vec3d u = Vec3d(1, 2, 0.5).normalized(), v = u.cross(Vec3d(0.3, -1, 2)).normalized();
    std::vector<Vec3d> points;
    for (int i = 0; i < 2 * spikes; ++i) {
        const double angle = std::numbers::pi * i / spikes;
        const double radius = i % 2 == 0 ? inner_radius : 1;
        points.emplace_back(radius * std::cos(angle) * u + radius * std::sin(angle) * v);
    }
    return points;
}

TEST(Triangulate, a_convex_polygon_stays_a_fan) {
    TriangleMesh mesh = fan_of(star(8, 0.95));
    const TriangleMesh fan = mesh;
    EXPECT_EQ(mend(mesh), 0u);
    EXPECT_EQ(mesh.faces, fan.faces);
}

TEST(Triangulate, a_concave_quad_is_cut_along_its_other_diagonal) {
    TriangleMesh mesh = fan_of({{0, 0, 0}, {4, 4, 0}, {0, 1, 0}, {-4, 4, 0}});
    EXPECT_NEAR(area(mesh), 4, 1e-12) << "this fan happens to be right";
    TriangleMesh turned = fan_of({{4, 4, 0}, {0, 1, 0}, {-4, 4, 0}, {0, 0, 0}});
    EXPECT_GT(area(turned), 5);
    mend(turned);
    EXPECT_NEAR(area(turned), 4, 1e-12);
}

TEST(Triangulate, a_quad_that_crosses_itself_stays_a_fan) {
    const std::vector<Vec3d> bow_tie = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}};
    for (std::size_t first = 0; first < 4; ++first) {
        for (const bool is_reversed : {false, true}) {
            std::vector<Vec3d> polygon = bow_tie;
            std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first),
                        polygon.end());
            if (is_reversed) std::reverse(polygon.begin(), polygon.end());
            TriangleMesh mesh = fan_of(polygon);
            const TriangleMesh fan = mesh;
            EXPECT_EQ(mend(mesh), 0u);
            EXPECT_EQ(mesh.faces, fan.faces) << first << is_reversed;
        }
    }
}

TEST(Triangulate, concave_polygons_are_covered_without_overlap) {
    for (const int spikes : {3, 5, 17, 200}) {
        for (const double inner : {0.1, 0.4, 0.7}) {
            TriangleMesh mesh = fan_of(star(spikes, inner));
            EXPECT_EQ(mend(mesh), 0u);
            EXPECT_EQ(mesh.faces.size(), mesh.vertices.size() - 2);
            const double expected = polygon_area(mesh.vertices);
            EXPECT_NEAR(area(mesh), expected, 1e-9 * expected) << spikes << " " << inner;
        }
    }
}

TEST(Triangulate, a_comb_in_each_plane_and_either_orientation) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool is_reversed : {false, true}) {
            std::vector<Vec3d> comb;
            for (int tooth = 0; tooth < 10; ++tooth) {
                for (const Vec2d& p : {Vec2d(2 * tooth, 5), Vec2d(2 * tooth + 1, 1)}) {
                    Vec3d point = Vec3d::Constant(7);
                    point[(axis + 1) % 3] = p.x();
                    point[(axis + 2) % 3] = p.y();
                    comb.push_back(point);
                }
            }
            for (const double x : {19.0, 0.0}) {
                Vec3d point = Vec3d::Constant(7);
                point[(axis + 1) % 3] = x;
                point[(axis + 2) % 3] = 0;
                comb.push_back(point);
            }
            if (is_reversed) std::reverse(comb.begin(), comb.end());
            TriangleMesh mesh = fan_of(comb);
            mend(mesh);
            EXPECT_NEAR(area(mesh), polygon_area(comb), 1e-9) << axis << is_reversed;
        }
    }
}

TEST(Triangulate, other_arrays_follow_the_faces) {
    TriangleMesh mesh = fan_of(star(5, 0.3));
    std::vector<Vec3i> other = mesh.faces;
    for (Vec3i& face : other) face += Vec3i::Constant(100);
    const PolygonFan fans[] = {{0, 10}};
    std::vector<Vec3i>* others[] = {&other};
    mend_fans(mesh.vertices, fans, mesh.faces, others);
    for (std::size_t i = 0; i < other.size(); ++i)
        EXPECT_EQ(other[i], mesh.faces[i] + Vec3i::Constant(100));
}

TEST(Triangulate, only_the_fans_named_are_touched) {
    TriangleMesh mesh{star(5, 0.3), {{0, 2, 4}}};
    for (int i = 1; i < 9; ++i) mesh.faces.emplace_back(0, i, i + 1);
    mesh.faces.emplace_back(1, 3, 5);
    const PolygonFan fans[] = {{1, 10}};
    mend_fans(mesh.vertices, fans, mesh.faces);
    EXPECT_EQ(mesh.faces.front(), Vec3i(0, 2, 4));
    EXPECT_EQ(mesh.faces.back(), Vec3i(1, 3, 5));
}

TEST(Triangulate, polygons_that_cross_themselves_repeat_or_have_no_place_keep_their_corners) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::vector<Vec3d>> polygons = {
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5, 0, 0}},
        {{0, 0, 0}, {1, kNan, 0}, {1, 0, 0}, {0, 1, 0}},
    };
    for (std::uint64_t round = 0; round < 200; ++round) {
        std::vector<Vec3d> polygon;
        for (std::uint32_t i = 0; i < 4 + round % 30; ++i)
            polygon.emplace_back(uniform(1, round, 2 * i), uniform(1, round, 2 * i + 1), 0);
        polygons.push_back(polygon);
    }
    for (const std::vector<Vec3d>& polygon : polygons) {
        TriangleMesh mesh = fan_of(polygon);
        mend(mesh);
        EXPECT_EQ(mesh.faces.size(), polygon.size() - 2);
        std::vector<bool> is_used(polygon.size());
        for (const Vec3i& face : mesh.faces)
            for (int k = 0; k < 3; ++k) is_used[static_cast<std::size_t>(face[k])] = true;
        EXPECT_EQ(is_used, std::vector<bool>(polygon.size(), true));
    }
}

TEST(Triangulate, huge_concave_polygons_are_counted_and_stay_fans) {
    TriangleMesh mesh = fan_of(star(600, 0.5));
    const std::vector<Vec3i> before = mesh.faces;
    // Seen from its first corner a star isn't covered by a fan.
    EXPECT_EQ(mend(mesh), 1u);
    EXPECT_EQ(mesh.faces, before);
}

TEST(Triangulate, large_simple_polygons_are_clipped) {
    // A band that winds up, first along its outer side and back along the inner one: all corners of
    // half of it point inwards.
    std::vector<Vec3d> spiral;
    constexpr int kSteps = 500;
    const auto place = [](int step, double radius) {
        const double angle = 0.1 * step;
        return Vec3d((radius + angle) * std::cos(angle), (radius + angle) * std::sin(angle), 0);
    };
    for (int step = 0; step < kSteps; ++step) spiral.push_back(place(step, 12));
    for (int step = kSteps; step-- > 0;) spiral.push_back(place(step, 10));
    for (const auto& polygon : {spiral, star(500, 0.1), star(500, 0.7)}) {
        TriangleMesh mesh = fan_of(polygon);
        EXPECT_EQ(mend(mesh), 0u);
        const double expected = polygon_area(polygon);
        EXPECT_NEAR(area(mesh), expected, 1e-9 * expected);
    }
}

}  // namespace
}  // namespace boxwood
