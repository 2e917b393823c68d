// SPDX-License-Identifier: Apache-2.0
// The sign of the distance: every method agrees with the sum of all solid angles on closed meshes,
// for every builder and instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "boxwood/mesh/generate.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/signed_distance.h"
#include "cases.h"
#include "laws/all_trees.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/point_families.h"

namespace boxwood {
namespace {

const MeshFamily kClosedMeshes[] = {
    {"cube", [] { return subdivided_cube(4); }},
    {"icosphere", [] { return generate_icosphere(1280); }},
    {"torus_knot", [] { return generate_torus_knot(2000); }},
    {"gyroid", [] { return generate_gyroid(2000); }},
    {"tiny",
     [] {
         return moved(generate_torus_knot(1000), 1e-6, {1e-3, 0, 0});
     }},
    {"huge",
     [] {
         return moved(generate_torus_knot(1000), 1e8, {0, 1e7, 0});
     }},
    {"far_away",
     [] {
         return moved(generate_icosphere(300), 1, {1e5, -1e5, 0});
     }},
};

class SignLaws : public testing::TestWithParam<MeshFamily> {};

TEST_P(SignLaws, every_method_agrees_with_the_exact_winding_number) {
    const TriangleMesh mesh = GetParam().make();
    const double size = bounds(mesh).extent().norm();
    std::vector<Vec3d> points;
    std::vector<double> expected;
    for (std::uint64_t seed = 0; points.size() < cases(std::size_t{400}); ++seed) {
        const Vec3d point = random_point(mesh, seed);
        const double distance = closest_point_brute_force(mesh, point)->distance;
        // Nearer to the surface rounding decides.
        if (distance < 1e-9 * size) continue;
        const double number = winding_number_brute_force(mesh, point);
        ASSERT_NEAR(number, std::round(number), 1e-6) << seed;
        points.push_back(point);
        expected.push_back(std::round(number) == 0 ? distance : -distance);
    }
    const std::vector<NamedTree> trees = all_trees(mesh);
    std::vector<SignedDistance> found(points.size());
    for (const auto& [method_name, method] : sign_methods()) {
        const MeshSign sign(mesh, method);
        ASSERT_TRUE(sign.is_trustworthy());
        for (const auto& [name, tree] : trees) {
            signed_distances(mesh, tree, sign, points, found);
            for (std::size_t i = 0; i < points.size(); ++i) {
                ASSERT_TRUE(same_bits(found[i].distance, expected[i]))
                    << method_name << ", " << name << ", point " << points[i].transpose()
                    << "\nfound " << found[i].distance << ", expected " << expected[i];
                ASSERT_FALSE(found[i].is_undefined)
                    << method_name << ", " << name << ", point " << points[i].transpose();
                const auto single = signed_distance(mesh, tree, sign, points[i]);
                ASSERT_TRUE(same_bits(single->distance, found[i].distance));
            }
        }
    }
}

/// Where the closest point is a corner or on an edge, the normal of one triangle alone tells
/// nothing: such points are outside, whatever side of its plane they are on.
TEST(SignsOfACube, around_the_corners_and_edges_of_a_cube_all_is_outside) {
    const TriangleMesh cube = subdivided_cube(1);
    const MeshSign sign(cube);
    for (const auto& [name, tree] : all_trees(cube)) {
        for (int i = 0; i < 27; ++i) {
            if (i == 13) continue;
            const Vec3d direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            for (int step = 1; step < 40; ++step) {
                const Vec3d skew(0.9 + 0.1 * std::cos(step), 0.9 + 0.1 * std::sin(step), 1);
                const Vec3d point =
                    Vec3d::Constant(0.5) + (0.5 + 0.05 * step) * direction.cwiseProduct(skew);
                const bool inside = (point.array() > 0).all() && (point.array() < 1).all();
                const auto found = signed_distance(cube, tree, sign, point);
                ASSERT_EQ(found->distance < 0, inside && found->distance != 0)
                    << name << ", point " << point.transpose();
            }
        }
    }
}

/// What the winding number is off by where it isn't exact, on every closed mesh.
TEST_P(SignLaws, hierarchical_winding_numbers_are_within_a_hundredth) {
    const TriangleMesh mesh = GetParam().make();
    const WindingTree tree(mesh);
    for (std::uint64_t seed = 0; seed < cases(400); ++seed) {
        const Vec3d point = random_point(mesh, seed);
        ASSERT_NEAR(winding_number(tree, point), winding_number_brute_force(mesh, point), 0.01)
            << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, SignLaws, testing::ValuesIn(kClosedMeshes),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace boxwood
