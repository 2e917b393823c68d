// SPDX-License-Identifier: Apache-2.0
// What goes wrong elsewhere when a mesh is asked for its inside: signs that flip, answers that
// differ from call to call.
#include <gtest/gtest.h>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/all_hits.h"
#include "boxwood/query/signed_distance.h"
#include "counterexamples/tree_over.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

/// Beyond an edge or a corner of a cube, the normal of the nearest triangle says "inside".
TEST(Counterexample, wrong_sign_outside_a_cube) {
    const TriangleMesh cube = subdivided_cube(1);
    const WideTree tree = tree_over(cube);
    for (const auto& [name, method] : sign_methods()) {
        const MeshSign sign(cube, method);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const Vec3d way(x, y, z), point = Vec3d::Constant(0.5) + 0.75 * way;
                    const auto found = signed_distance(cube, tree, sign, point);
                    ASSERT_TRUE(found);
                    EXPECT_EQ(found->distance > 0, !way.isZero()) << name << point.transpose();
                }
    }
}

/// Whether a point is inside depends on the direction in which a ray happens to look.
TEST(Counterexample, inside_test_differing_between_rays) {
    const TriangleMesh cube = subdivided_cube(4);
    const WideTree tree = tree_over(cube);
    Random random(7);
    // On a lattice, so that rays along axes and diagonals meet edges and vertices.
    for (int i = 0; i < 2000; ++i) {
        const Vec3d point = random.point(-3, 8).array().floor() / 8 + 1.0 / 16;
        const bool inside = (point.array() > 0).all() && (point.array() < 1).all();
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const Vec3d direction(x, y, z);
                    if (direction.isZero()) continue;
                    const Ray ray = {.origin = point, .direction = direction};
                    ASSERT_EQ(count_hits(cube, tree, ray) % 2 == 1, inside)
                        << point.transpose() << " towards " << direction.transpose();
                }
    }
}

/// The same question, asked again or on more threads, has another answer.
TEST(Counterexample, inside_test_differing_between_calls) {
    const TriangleMesh knot = generate_torus_knot(500);
    const WideTree tree = tree_over(knot);
    const MeshSign sign(knot, SignMethod::ray_parity);
    Random random(8);
    std::vector<Vec3d> points;
    for (int i = 0; i < 3000; ++i) points.push_back(random.point(-1, 1));
    std::vector<SignedDistance> first(points.size()), again(points.size());
    signed_distances(knot, tree, sign, points, first);
    for (const std::size_t threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        signed_distances(knot, tree, sign, points, again);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_EQ(first[i].distance, again[i].distance) << i;
            const auto alone = signed_distance(knot, tree, sign, points[i]);
            ASSERT_TRUE(alone);
            ASSERT_EQ(first[i].distance, alone->distance) << i;
        }
    }
}

}  // namespace
}  // namespace boxwood
