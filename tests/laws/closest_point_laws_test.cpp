// SPDX-License-Identifier: Apache-2.0
// The closest point: the same bits as one triangle at a time, for every builder, width and
// instruction set that this machine has, and near enough to what long double finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "boxwood/query/brute_force.h"
#include "boxwood/query/closest_point.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/point_families.h"
#include "laws/point_triangle_oracle.h"

namespace boxwood {

/// How failed tests show it.
static void PrintTo(const ClosestPoint& closest, std::ostream* out) {
    const auto precision = out->precision(17);
    *out << "distance " << closest.distance << " triangle " << closest.triangle << " u "
         << closest.u << " v " << closest.v << " point " << closest.point.transpose() << " part "
         << static_cast<int>(closest.part);
    out->precision(precision);
}

namespace {

bool have_same_bits(const ClosestPoint& a, const ClosestPoint& b) {
    bool same = same_bits(a.distance, b.distance) && same_bits(a.u, b.u) && same_bits(a.v, b.v) &&
                a.triangle == b.triangle && a.part == b.part;
    for (int k = 0; k < 3; ++k) same = same && same_bits(a.point[k], b.point[k]);
    return same;
}

constexpr std::uint64_t kPoints = cases(500);

/// Most queries have none; some an exact one, some one that is a bit too small.
double random_radius(MeshView mesh, const Vec3d& point, std::uint64_t seed) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (seed % 3 != 0) return kInfinity;
    const auto closest = closest_point_brute_force(mesh, point);
    if (!closest) return 1;
    switch (seed / 3 % 4) {
        case 0:
            return closest->distance;
        case 1:
            return std::nextafter(closest->distance, -kInfinity);
        case 2:
            return 1.5 * closest->distance;
        default:
            return 0;
    }
}

class ClosestPointLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(ClosestPointLaws, trees_equal_brute_force_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    const std::vector<NamedTree> trees = all_trees(mesh);
    for (std::uint64_t seed = 0; seed < kPoints; ++seed) {
        const Vec3d point = random_point(mesh, seed);
        const double radius = random_radius(mesh, point, seed);
        const auto expected = closest_point_brute_force(mesh, point, radius);
        for (const auto& [name, tree] : trees) {
            const auto found = closest_point(mesh, tree, point, radius);
            ASSERT_EQ(found.has_value(), expected.has_value()) << name << ", seed " << seed;
            if (!found) continue;
            ASSERT_TRUE(have_same_bits(*found, *expected))
                << name << ", seed " << seed << "\nfound    " << testing::PrintToString(*found)
                << "\nexpected " << testing::PrintToString(*expected);
        }
    }
}

TEST_P(ClosestPointLaws, batches_equal_single_points_to_the_last_bit) {
    const TriangleMesh mesh = GetParam().make();
    std::vector<Vec3d> points;
    for (std::uint64_t seed = 0; seed < kPoints; ++seed) points.push_back(random_point(mesh, seed));
    std::vector<ClosestPoint> expected, found(points.size());
    const double radius = 2 * bounds(mesh).extent().norm();
    for (const Vec3d& point : points)
        expected.push_back(closest_point_brute_force(mesh, point, radius).value_or(ClosestPoint{}));
    for (const auto& [name, tree] : all_trees(mesh)) {
        closest_points(mesh, tree, points, found, radius);
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_TRUE(have_same_bits(found[i], expected[i]))
                << name << ", seed " << i << "\nfound    " << testing::PrintToString(found[i])
                << "\nexpected " << testing::PrintToString(expected[i]);
    }
}

TEST_P(ClosestPointLaws, brute_force_is_as_near_as_long_double_finds) {
    const TriangleMesh triangles = GetParam().make();
    const MeshView mesh = triangles;
    for (std::uint64_t seed = 0; seed < kPoints; ++seed) {
        const Vec3d point = random_point(mesh, seed);
        const auto found = closest_point_brute_force(mesh, point);
        long double least = std::numeric_limits<long double>::infinity();
        double reach = 0;
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            if (triangle_box(mesh, i).is_empty()) continue;
            least = std::min(least, distance_in_long_double(point, mesh.corner(i, 0),
                                                            mesh.corner(i, 1), mesh.corner(i, 2)));
        }
        ASSERT_EQ(found.has_value(),
                  point.lpNorm<Eigen::Infinity>() <= 1e150 && std::isfinite(least))
            << seed;
        if (!found) continue;
        for (int k = 0; k < 3; ++k)
            reach = std::max(reach, (mesh.corner(found->triangle, k) - point).norm());
        EXPECT_NEAR(found->distance, static_cast<double>(least), 1e-12 * reach) << seed;
        // The point is where it says, and at that distance.
        const Vec3d &a = mesh.corner(found->triangle, 0), &b = mesh.corner(found->triangle, 1),
                    &c = mesh.corner(found->triangle, 2);
        const Vec3d at = (1 - found->u - found->v) * a + found->u * b + found->v * c;
        const double size = std::max({a.norm(), b.norm(), c.norm(), point.norm()});
        EXPECT_NEAR((at - found->point).norm(), 0, 1e-15 * size) << seed;
        EXPECT_NEAR((point - found->point).norm(), found->distance, 1e-15 * size) << seed;
        EXPECT_TRUE(found->u >= 0 && found->v >= 0 && found->u + found->v <= 1 + 1e-15) << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Families, ClosestPointLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
