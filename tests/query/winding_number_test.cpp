// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/winding_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/solid_angle.h"
#include "cases.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

TEST(WindingNumber, an_octant_is_an_eighth_of_a_sphere) {
    EXPECT_NEAR(solid_angle({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}), 0.125, 1e-15);
    EXPECT_NEAR(solid_angle({0, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 0, 3}), -0.125, 1e-15);
}

TEST(WindingNumber, a_plane_that_holds_the_point_covers_nothing) {
    EXPECT_EQ(solid_angle({0.2, 0.2, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    EXPECT_EQ(solid_angle({2, 2, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    EXPECT_EQ(solid_angle({0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
}

TEST(WindingNumber, is_whole_inside_and_outside_of_closed_meshes) {
    const TriangleMesh cube = subdivided_cube(4);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3d point = random.point(-1, 2);
        const bool inside = (point.array() > 0).all() && (point.array() < 1).all();
        EXPECT_NEAR(winding_number_brute_force(cube, point), inside ? 1 : 0, 1e-12);
    }
    EXPECT_NEAR(winding_number_brute_force(cube, {1, 0.3, 0.3}), 0.5, 1e-12);
    EXPECT_NEAR(winding_number_brute_force(cube, {1, 1, 1}), 0.125, 1e-12);
}

TEST(WindingNumber, counts_overlapping_parts_and_turns_with_the_triangles) {
    TriangleMesh two = subdivided_cube(2);
    const TriangleMesh other = moved(two, 1, {0.5, 0, 0});
    const int offset = static_cast<int>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Vec3i& face : other.faces)
        two.faces.emplace_back(face[0] + offset, face[1] + offset, face[2] + offset);
    EXPECT_NEAR(winding_number(WindingTree(two), {0.7, 0.4, 0.4}), 2, 0.01);
    for (Vec3i& face : two.faces) std::swap(face[0], face[1]);
    EXPECT_NEAR(winding_number(WindingTree(two), {0.2, 0.4, 0.4}), -1, 0.01);
}

TEST(WindingNumber, errors_fall_with_the_accuracy_that_is_asked_for) {
    const TriangleMesh mesh = generate_torus_knot(20'000);
    const WindingTree tree(mesh);
    Random random(2);
    double worst[3] = {};
    constexpr double kAccuracies[3] = {1.5, 2, 6};
    for (int i = 0; i < cases(300); ++i) {
        const Vec3d point = random.point(-1.2, 1.2);
        const double exact = winding_number_brute_force(mesh, point);
        for (int k = 0; k < 3; ++k) {
            const double found = winding_number(tree, point, {.accuracy = kAccuracies[k]});
            worst[k] = std::max(worst[k], std::abs(found - exact));
        }
    }
    EXPECT_LT(worst[1], 0.01);
    EXPECT_LT(worst[2], 0.0005);
    EXPECT_LT(worst[2], 0.2 * worst[0]);
}

TEST(WindingNumber, the_expansion_is_of_second_order) {
    // Seen from twice as far, an open patch is off by an eighth of an eighth of its size: two
    // orders beyond the field of a dipole, which itself falls with the square.
    const TriangleMesh patch = generate_terrain(2000);
    const WindingTree tree(patch);
    const auto error_at = [&](double distance) {
        double worst = 0;
        Random random(3);
        for (int i = 0; i < 50; ++i) {
            const Vec3d point = distance * random.direction();
            worst = std::max(worst, std::abs(winding_number(tree, point, {.accuracy = 1}) -
                                             winding_number_brute_force(patch, point)));
        }
        return worst;
    };
    EXPECT_LT(error_at(16), error_at(8) / 20);
    EXPECT_LT(error_at(32), error_at(16) / 20);
}

TEST(WindingNumber, bad_input_counts_for_nothing) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(winding_number(WindingTree(TriangleMesh()), {0, 0, 0}), 0);
    TriangleMesh cube = subdivided_cube(2);
    EXPECT_EQ(winding_number(WindingTree(cube), {kNaN, 0, 0}), 0);
    EXPECT_EQ(winding_number_brute_force(cube, {kNaN, 0, 0}), 0);
    cube.vertices.emplace_back(kNaN, 0, 0);
    cube.faces.emplace_back(0, 1, static_cast<int>(cube.vertices.size()) - 1);
    EXPECT_NEAR(winding_number(WindingTree(cube), {0.4, 0.4, 0.6}, {.accuracy = kNaN}), 1, 0.2);
    EXPECT_NEAR(winding_number_brute_force(cube, {0.4, 0.4, 0.6}), 1, 1e-12);
}

TEST(WindingNumber, batch_answers_each_point) {
    const TriangleMesh mesh = generate_icosphere(500);
    const WindingTree tree(mesh);
    Random random(4);
    std::vector<Vec3d> points;
    for (int i = 0; i < 5000; ++i) points.push_back(random.point(-2, 2));
    std::vector<double> results(points.size());
    winding_numbers(tree, points, results);
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(results[i], winding_number(tree, points[i]));
    results.pop_back();
    EXPECT_THROW(winding_numbers(tree, points, results), InvalidInput);
}

}  // namespace
}  // namespace boxwood
