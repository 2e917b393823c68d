// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/scene.h"

#include <gtest/gtest.h>

#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

TEST(Scene, hit_names_the_mesh_and_its_triangle) {
    const TriangleMesh near = moved(flat_grid(4), 1, {-2, -2, 1});
    const TriangleMesh far = moved(flat_grid(4), 1, {-2, -2, -1});
    for (const bool brute_force : {false, true}) {
        const Scene scene({far, near}, {.brute_force = brute_force});
        const auto hit = scene.closest_hit({.origin = {0.25, 0.125, 3}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->mesh, 1u);
        EXPECT_EQ(hit->t, 2);
        EXPECT_EQ(hit->triangle, 20u);
    }
}

TEST(Scene, equal_distances_go_to_the_lower_mesh) {
    const TriangleMesh mesh = flat_grid(4);
    const Scene scene({mesh, mesh, mesh});
    const Ray ray = {.origin = {2.25, 2.125, 3}};
    EXPECT_EQ(scene.closest_hit(ray)->mesh, 0u);
}

TEST(Scene, skip_leaves_out_one_triangle_of_one_mesh) {
    const TriangleMesh mesh = flat_grid(4);
    const Scene scene({mesh, mesh});
    Ray ray = {.origin = {2.25, 2.125, 3}};
    const auto first = scene.closest_hit(ray);
    ray.skip = {first->mesh, first->triangle};
    const auto second = scene.closest_hit(ray);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->mesh, 1u);
    EXPECT_EQ(second->triangle, first->triangle);
    EXPECT_TRUE(scene.any_hit(ray));
}

TEST(Scene, nothing_is_never_hit) {
    const TriangleMesh nothing;
    for (const bool brute_force : {false, true}) {
        const SceneOptions options = {.brute_force = brute_force};
        EXPECT_FALSE(Scene({}, options).closest_hit({}));
        EXPECT_FALSE(Scene({}, options).any_hit({}));
        const Scene scene({nothing, nothing}, options);
        EXPECT_FALSE(scene.closest_hit({}));
        EXPECT_FALSE(scene.any_hit({}));
    }
}

TEST(Scene, has_a_tree_a_mesh_but_none_where_it_is_brute_force) {
    const TriangleMesh mesh = generate_soup(50), nothing;
    EXPECT_EQ(Scene({mesh, nothing, mesh}).wide_trees().size(), 3u);
    EXPECT_TRUE(Scene({mesh, nothing, mesh}).trees().empty());
    EXPECT_EQ(Scene({mesh, nothing, mesh}, {.keep_trees = true}).trees().size(), 3u);
    EXPECT_TRUE(Scene({mesh}, {.brute_force = true}).wide_trees().empty());
    EXPECT_EQ(Scene({mesh, nothing}).meshes().size(), 2u);
}

TEST(Scene, indices_out_of_range_are_refused) {
    for (const int bad : {-1, 3, 1'000'000}) {
        const TriangleMesh mesh = {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                   .faces = {{0, 1, 2}, {0, bad, 2}}};
        EXPECT_THROW(Scene({mesh}), InvalidInput) << bad;
        EXPECT_THROW(Scene({mesh}, {.brute_force = true}), InvalidInput) << bad;
    }
}

TEST(Scene, counts_its_own_nodes_and_those_of_its_meshes) {
    const TriangleMesh mesh = generate_icosphere(500);
    TraversalCounts counts;
    Scene({mesh}, {.keep_trees = true}).closest_hit({.origin = {0.1, 0.2, 5}}, counts);
    EXPECT_GT(counts.nodes, 2u);
    EXPECT_GT(counts.primitives, 0u);
    TraversalCounts brute;
    Scene({mesh}, {.brute_force = true}).closest_hit({.origin = {0.1, 0.2, 5}}, brute);
    EXPECT_EQ(brute.primitives, mesh.faces.size());
    EXPECT_FALSE(Scene({mesh}).counts_steps());
}

}  // namespace
}  // namespace boxwood
