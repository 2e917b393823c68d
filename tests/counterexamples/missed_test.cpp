// SPDX-License-Identifier: Apache-2.0
// What is missed elsewhere, or hit where there is nothing: by epsilons, by bad vertices, by float.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/mesh/generate.h"
#include "boxwood/query/all_hits.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_point.h"
#include "counterexamples/tree_over.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// A ray that passes a triangle's rim, or runs in its plane beside it, hits it.
TEST(Counterexample, phantom_hit_outside_the_mesh) {
    const TriangleMesh mesh = {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
    const WideTree tree = tree_over(mesh);
    const double beyond = std::nextafter(0.5, 1.0);
    EXPECT_TRUE(any_hit(mesh, tree, {.origin = {0.5, 0.5, 1}}));
    EXPECT_FALSE(any_hit(mesh, tree, {.origin = {beyond, 0.5, 1}}));
    EXPECT_FALSE(any_hit(mesh, tree, {.origin = {-0x1p-1000, 0.5, 1}}));
    EXPECT_FALSE(any_hit(mesh, tree, {.origin = {-1, 2, 0}, .direction = {1, 0, 0}}));
    EXPECT_FALSE(any_hit(mesh, tree, {.origin = {-1, 1.5, 0}, .direction = {1, 0.25, 0}}));
}

/// Far from the origin, a ray in float hits what it passes by.
TEST(Counterexample, phantom_hit_far_from_the_origin) {
    const Vec3d offset(1e8, -1e8, 1e8);
    const TriangleMesh cube = moved(subdivided_cube(1), 1, offset);
    const WideTree tree = tree_over(cube);
    for (const double past : {-0.25, 1.25})
        EXPECT_FALSE(any_hit(cube, tree, {.origin = offset + Vec3d(past, 0.5, 3)}));
    EXPECT_TRUE(any_hit(cube, tree, {.origin = offset + Vec3d(0.25, 0.5, 3)}));
}

/// Triangles below some fixed size count as degenerate.
TEST(Counterexample, small_triangles_lost_through_epsilons) {
    for (const double scale : {1e-3, 1e-6, 1e-9, 1e-12, 1e-30}) {
        const TriangleMesh sphere = moved(generate_icosphere(320), scale, Vec3d::Zero());
        const WideTree tree = tree_over(sphere);
        const Ray ray = {.origin = scale * Vec3d(3, 0.1, 0.2), .direction = {-1, 0, 0}};
        EXPECT_EQ(count_hits(sphere, tree, ray), 2u) << scale;
        const auto hit = closest_hit(sphere, tree, ray);
        ASSERT_TRUE(hit) << scale;
        EXPECT_NEAR(hit->t, 2 * scale, 0.2 * scale);
    }
}

/// Hits nearer than some fixed epsilon are thrown away as hits on the ray's own surface.
TEST(Counterexample, near_hits_lost_through_epsilons) {
    const TriangleMesh grid = moved(flat_grid(2), 1, {-1, -1, 0});
    const WideTree tree = tree_over(grid);
    const Ray ray = {.origin = {0.25, 0.5, 1e-12}};
    const auto hit = closest_hit(grid, tree, ray);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1e-12, 1e-27);
    EXPECT_EQ(count_hits(grid, tree, ray), 1u);
}

/// One vertex that isn't a number makes the boxes around it swallow the whole mesh.
TEST(Counterexample, nan_vertex_hiding_a_mesh) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        TriangleMesh mesh = subdivided_cube(4);
        mesh.vertices.emplace_back(bad, 0.5, 0.5);
        mesh.faces.emplace_back(0, 1, static_cast<int>(mesh.vertices.size()) - 1);
        const WideTree tree = tree_over(mesh);
        for (int i = 1; i < 16; ++i) {
            const Ray ray = {.origin = {i / 16.0, 0.3, 2}};
            const auto hit = closest_hit(mesh, tree, ray);
            ASSERT_TRUE(hit) << i;
            EXPECT_EQ(hit->t, 1) << i;
            EXPECT_EQ(count_hits(mesh, tree, ray), 2u) << i;
        }
        const auto closest = closest_point(mesh, tree, {0.5, 0.5, 3});
        ASSERT_TRUE(closest);
        EXPECT_EQ(closest->distance, 2);
    }
}

/// A triangle a billion times longer than wide is missed by a ray straight at it.
TEST(Counterexample, sliver_missed) {
    for (const double width : {1e-6, 1e-9, 1e-12, 1e-15}) {
        const TriangleMesh sliver = {.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, width, 0}},
                                     .faces = {{0, 1, 2}}};
        const WideTree tree = tree_over(sliver);
        for (const double x : {0.25, 0.5, 0.75}) {
            const Ray ray = {.origin = {x, 0.25 * width, 1}};
            EXPECT_TRUE(any_hit(sliver, tree, ray)) << width << " " << x;
            EXPECT_EQ(count_hits(sliver, tree, ray), 1u) << width << " " << x;
        }
        EXPECT_FALSE(any_hit(sliver, tree, {.origin = {0.5, 1.25 * width, 1}}));
    }
}

}  // namespace
}  // namespace boxwood
