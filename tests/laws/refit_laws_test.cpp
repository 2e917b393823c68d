// SPDX-License-Identifier: Apache-2.0
// A tree that was fitted to a moved mesh gives the answers of brute force on that, to the last bit:
// for every builder, width, instruction set and layout, whatever moved where.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "boxwood/query/brute_force.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_point.h"
#include "boxwood/query/overlaps.h"
#include "boxwood/query/refit.h"
#include "boxwood/query/wide_fault.h"
#include "boxwood/query/wide_hits.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/float_hits.h"
#include "laws/float_oracle.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"
#include "rounded_to_float.h"

namespace boxwood {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Move {
    const char* name;
    Vec3d (*place)(const Vec3d& p, Random& random);
};

/// One after another, each from where the mesh was first.
constexpr Move kMoves[] = {
    {"nowhere", [](const Vec3d& p, Random&) { return p; }},
    {"a bit", [](const Vec3d& p, Random& random) -> Vec3d { return p + random.point(-0.1, 0.1); }},
    {"where nobody was", [](const Vec3d&, Random& random) { return random.point(-5, 5); }},
    {"some out of all range",
     [](const Vec3d& p, Random& random) -> Vec3d {
         const double bad[] = {kNaN, kInfinity, -kInfinity, 1e39};
         Vec3d result = p;
         if (random.index(9) == 0) result[static_cast<int>(random.index(3))] = bad[random.index(4)];
         return result;
     }},
    {"all out of all range",
     [](const Vec3d&, Random&) -> Vec3d {
         return {0, kNaN, 1};
     }},
    {"to another scale",
     [](const Vec3d& p, Random&) -> Vec3d { return p * (p.norm() > 1e10 ? 1e-25 : 1e25); }},
    {"to one place",
     [](const Vec3d&, Random&) -> Vec3d {
         return {1, 2, 3};
     }},
    {"to floats",
     [](const Vec3d& p, Random&) -> Vec3d { return rounded_to_float(std::span(&p, 1))[0]; }},
    {"back", [](const Vec3d& p, Random&) { return p; }},
};

bool is_in_range(const Vec3d& p) { return (p.array().abs() <= FLT_MAX).all(); }

/// Vertices that are out of range stay, as triangles that have no place must not come back.
TriangleMesh after(const Move& move, const TriangleMesh& mesh) {
    Random random(41);
    TriangleMesh result = mesh;
    for (Vec3d& vertex : result.vertices) {
        if (is_in_range(vertex)) vertex = move.place(vertex, random);
    }
    return result;
}

class RefitLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(RefitLaws, rays_see_the_moved_mesh) {
    const TriangleMesh mesh = GetParam().make();
    std::vector<NamedTree> trees = all_trees(mesh);
    for (const Move& move : kMoves) {
        const TriangleMesh moved = after(move, mesh);
        for (auto& [name, tree] : trees) {
            refit(tree, moved);
            ASSERT_EQ(find_fault(tree.parts()).value_or("none"), "none") << name << move.name;
        }
        for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
            const Ray ray = random_ray(moved, seed);
            const auto expected = closest_hit_brute_force(moved, ray);
            const float scale = trees[0].tree.scale();
            const auto expected_float = FloatOracle(moved, in_float(ray), scale).closest_hit();
            for (const auto& [name, tree] : trees) {
                SCOPED_TRACE(name + ", moved " + move.name + ", seed " + std::to_string(seed));
                ASSERT_EQ(tree.scale(), scale);
                ASSERT_TRUE(have_same_bits(closest_hit(tree, in_float(ray)), expected_float));
                ASSERT_EQ(any_hit(tree, in_float(ray)), expected_float.has_value());
                ASSERT_TRUE(are_identical(closest_hit(moved, tree, ray), expected));
                ASSERT_EQ(any_hit(moved, tree, ray), expected.has_value());
            }
        }
    }
}

TEST_P(RefitLaws, points_and_boxes_see_the_moved_mesh) {
    const TriangleMesh mesh = GetParam().make();
    std::vector<NamedTree> trees = all_trees(mesh);
    for (const Move& move : kMoves) {
        const TriangleMesh moved = after(move, mesh);
        for (auto& [name, tree] : trees) refit(tree, moved);
        for (std::uint64_t seed = 0; seed < cases(15); ++seed) {
            Random random(seed);
            const Vec3d point = random.point(-2, 2);
            const Box3d box = {point, point + random.point(0, 1)};
            const auto expected = closest_point_brute_force(moved, point, kInfinity);
            std::vector<std::uint32_t> touching;
            for (std::uint32_t i = 0; i < moved.faces.size(); ++i) {
                const MeshView view = moved;
                const bool is_finite = is_in_range(view.corner(i, 0)) &&
                                       is_in_range(view.corner(i, 1)) &&
                                       is_in_range(view.corner(i, 2));
                if (is_finite && overlap(box, corners_of(moved, i))) touching.push_back(i);
            }
            for (const auto& [name, tree] : trees) {
                SCOPED_TRACE(name + ", moved " + move.name + ", seed " + std::to_string(seed));
                const auto found = closest_point(moved, tree, point);
                ASSERT_EQ(found.has_value(), expected.has_value());
                if (found) {
                    ASSERT_EQ(found->triangle, expected->triangle);
                    ASSERT_EQ(found->distance, expected->distance);
                }
                ASSERT_EQ(box_overlap(moved, tree, box), touching);
            }
        }
    }
}

TEST_P(RefitLaws, nothing_moved_costs_what_it_did) {
    const TriangleMesh mesh = GetParam().make();
    for (auto& [name, tree] : all_trees(mesh)) {
        // Where triangles are split, their boxes become whole.
        if (name.starts_with("spatial_split") || name.starts_with("reinsertion")) continue;
        const double cost = tree.cost();
        const RefitQuality quality = refit(tree, mesh);
        ASSERT_EQ(quality.cost_at_build, cost) << name;
        ASSERT_NEAR(quality.cost, cost, 1e-5 * cost) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Families, RefitLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
