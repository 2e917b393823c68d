// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/brute_force.h"
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
        EXPECT_EQ(hit->instance, 1u);
        EXPECT_EQ(hit->t, 2);
        EXPECT_EQ(hit->triangle, 20u);
    }
}

TEST(Scene, equal_distances_go_to_the_lower_mesh) {
    const TriangleMesh mesh = flat_grid(4);
    const Scene scene({mesh, mesh, mesh});
    const Ray ray = {.origin = {2.25, 2.125, 3}};
    EXPECT_EQ(scene.closest_hit(ray)->instance, 0u);
}

TEST(Scene, skip_leaves_out_one_triangle_of_one_mesh) {
    const TriangleMesh mesh = flat_grid(4);
    const Scene scene({mesh, mesh});
    Ray ray = {.origin = {2.25, 2.125, 3}};
    const auto first = scene.closest_hit(ray);
    ray.skip = {first->instance, first->triangle};
    const auto second = scene.closest_hit(ray);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->instance, 1u);
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

/// One triangle in the plane z = 0 about the z axis; its front is seen from above.
TriangleMesh flat_triangle() {
    return {.vertices = {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}, .faces = {{0, 1, 2}}};
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Scene, instances_stand_where_their_transforms_say) {
    const TriangleMesh mesh = flat_triangle();
    Instance low, high;
    low.to_world.translate(Vec3d(0, 0, -3));
    high.to_world.translate(Vec3d(10, 0, 2)).scale(2);
    const Scene scene({mesh}, {low, high}, {});
    const auto at_low = scene.closest_hit({.origin = {0, 0, 5}});
    ASSERT_TRUE(at_low);
    EXPECT_EQ(at_low->t, 8);
    EXPECT_EQ(at_low->instance, 0u);
    const auto at_high = scene.closest_hit({.origin = {10, 0, 5}});
    ASSERT_TRUE(at_high);
    EXPECT_EQ(at_high->t, 3);
    EXPECT_EQ(at_high->instance, 1u);
    EXPECT_TRUE(scene.any_hit({.origin = {13.5, -1.5, 5}}));
    EXPECT_FALSE(scene.any_hit({.origin = {5, 0, 5}}));
}

TEST(Scene, meshes_without_an_instance_are_not_seen) {
    const TriangleMesh mesh = flat_triangle();
    EXPECT_FALSE(Scene({mesh}, {}, SceneOptions{}).any_hit({.origin = {0, 0, 5}}));
    EXPECT_TRUE(Scene({mesh}).any_hit({.origin = {0, 0, 5}}));
}

TEST(Scene, rays_see_the_instances_that_share_a_bit_with_them) {
    const TriangleMesh mesh = flat_triangle();
    Instance low, high;
    high.to_world.translate(Vec3d(0, 0, 1));
    low.visibility = 0b011;
    high.visibility = 0b100;
    for (const bool brute_force : {false, true}) {
        const Scene scene({mesh}, {low, high}, {.brute_force = brute_force});
        Ray ray = {.origin = {0, 0, 5}};
        EXPECT_EQ(scene.closest_hit(ray)->instance, 1u);
        EXPECT_EQ(scene.count_hits(ray), 2u);
        ray.visibility = 0b001;
        EXPECT_EQ(scene.closest_hit(ray)->instance, 0u);
        EXPECT_EQ(scene.count_hits(ray), 1u);
        ray.visibility = 0b1000;
        EXPECT_FALSE(scene.any_hit(ray));
        EXPECT_FALSE(scene.closest_hit(ray));
        std::vector<Hit> first(1);
        EXPECT_EQ(scene.first_k_hits(ray, first), 0u);
    }
}

TEST(Scene, a_mesh_that_culls_is_hit_from_the_front_alone) {
    const TriangleMesh mesh = flat_triangle();
    const Ray down = {.origin = {0, 0, 5}};
    const Ray up = {.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    Instance mirrored;
    mirrored.to_world.scale(Vec3d(-1, 1, 1));
    for (const bool brute_force : {false, true}) {
        const SceneOptions options = {.brute_force = brute_force};
        const Scene scene({SceneMesh(mesh, true)}, options);
        EXPECT_TRUE(scene.closest_hit(down) && scene.any_hit(down));
        EXPECT_FALSE(scene.closest_hit(up) || scene.any_hit(up));
        EXPECT_EQ(scene.count_hits(down), 1u);
        EXPECT_EQ(scene.count_hits(up), 0u);
        EXPECT_TRUE(Scene({mesh}, options).any_hit(up));
        // The front goes with the mesh.
        const Scene turned({SceneMesh(mesh, true)}, {mirrored}, options);
        EXPECT_TRUE(turned.closest_hit(down));
        EXPECT_FALSE(turned.closest_hit(up));
        EXPECT_EQ(turned.geometric_normal(*turned.closest_hit(down)), Vec3d(0, 0, 1));
    }
}

TEST(Scene, vertices_in_float_are_those_numbers_in_double) {
    const std::vector<Vec3f> vertices = {{-1, -1, 0.1f}, {2, -1, 0.1f}, {-1, 2, 0.1f}};
    const std::vector<Vec3i> faces = {{0, 1, 2}};
    const Scene scene({MeshViewf{vertices, faces}});
    const auto hit = scene.closest_hit({.origin = {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 1 - double{0.1f});
    EXPECT_EQ(scene.meshes()[0].vertices.size(), 3u);
}

TEST(Scene, reports_the_triangles_that_nothing_can_be_done_with) {
    TriangleMesh mesh = flat_triangle();
    mesh.vertices.insert(mesh.vertices.end(), {{kNaN, 0, 0}, {1e39, 0, 0}, {0, 0, 0}, {1, 1, 1}});
    mesh.faces = {{0, 1, 3}, {0, 1, 2}, {0, 0, 1}, {0, 1, 4}, {2, 2, 2}};
    for (const bool brute_force : {false, true}) {
        const Scene scene({mesh, flat_triangle()}, {.brute_force = brute_force});
        ASSERT_EQ(scene.report().meshes.size(), 2u);
        EXPECT_EQ(scene.report().meshes[0].not_finite, (std::vector<std::uint32_t>{0, 3}));
        EXPECT_EQ(scene.report().meshes[0].zero_area, (std::vector<std::uint32_t>{2, 4}));
        EXPECT_TRUE(scene.report().has_faults());
        EXPECT_TRUE(scene.any_hit({.origin = {0, 0, 5}}));
    }
    EXPECT_FALSE(Scene({flat_triangle()}).report().has_faults());
}

/// What the constructor says of an instance.
std::string refusal(const Instance& instance) {
    const TriangleMesh mesh = flat_triangle();
    try {
        const Scene scene({mesh}, {Instance(), instance}, SceneOptions{});
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(Scene, instances_that_make_no_sense_are_refused_by_name) {
    EXPECT_EQ(refusal({}), "");
    EXPECT_EQ(refusal({.mesh = 1}), "instance 1: found mesh 1, expected less than 1");
    Instance flat, nan, nowhere;
    flat.to_world.scale(Vec3d(1, 0, 1));
    EXPECT_EQ(refusal(flat),
              "instance 1: found a transform that flattens space, expected one with an inverse");
    nan.to_world.linear()(0, 1) = kNaN;
    EXPECT_EQ(refusal(nan),
              "instance 1: found a transform with a number that isn't finite, expected none");
    nowhere.to_world.translation()[2] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(nowhere),
              "instance 1: found a transform with a number that isn't finite, expected none");
}

TEST(Scene, moved_instances_are_hit_where_they_are_now) {
    const TriangleMesh mesh = flat_triangle();
    Scene scene({mesh}, {Instance(), Instance()}, {});
    Instance moved;
    moved.to_world.translate(Vec3d(0, 0, 2));
    scene.set_instances({moved, moved, Instance()});
    const auto hit = scene.closest_hit({.origin = {0, 0, 5}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 3);
    EXPECT_EQ(hit->instance, 0u);
    EXPECT_EQ(scene.count_hits({.origin = {0, 0, 5}}), 3u);
    EXPECT_THROW(scene.set_instances({Instance{.mesh = 7}}), InvalidInput);
    EXPECT_EQ(scene.instances().size(), 3u);
    scene.set_instances({});
    EXPECT_FALSE(scene.any_hit({.origin = {0, 0, 5}}));
}

TEST(Scene, refit_answers_as_a_new_scene) {
    TriangleMesh mesh = generate_icosphere(500);
    std::vector<Vec3f> floats;
    for (const Vec3d& vertex : mesh.vertices) floats.push_back(vertex.cast<float>());
    Instance aside;
    aside.to_world.translate(Vec3d(3, 0, 0));
    aside.mesh = 1;
    const std::vector<SceneMesh> meshes = {mesh, MeshViewf{floats, mesh.faces}};
    const std::vector<Instance> instances = {Instance(), aside};
    Scene scene(meshes, instances, {.keep_trees = true});
    for (std::size_t i = 0; i < floats.size(); ++i) {
        mesh.vertices[i] *= 1 + 0.1 * std::sin(static_cast<double>(i));
        floats[i] *= 2;
    }
    const std::vector<RefitQuality> qualities = scene.refit();
    ASSERT_EQ(qualities.size(), 2u);
    EXPECT_NE(qualities[0].ratio(), 1);
    EXPECT_NEAR(qualities[1].ratio(), 1, 1e-6);
    const Scene anew(meshes, instances, {.brute_force = true});
    for (int i = 0; i < 200; ++i) {
        const Ray ray = {.origin = {std::sin(i) * 4, std::cos(3.0 * i), 5}};
        const auto expected = anew.closest_hit(ray), found = scene.closest_hit(ray);
        TraversalCounts counts;
        const auto counted = scene.closest_hit(ray, counts);
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        ASSERT_EQ(counted.has_value(), expected.has_value()) << i;
        if (!expected) continue;
        EXPECT_EQ(found->t, expected->t) << i;
        EXPECT_EQ(found->triangle, expected->triangle) << i;
        EXPECT_EQ(counted->t, expected->t) << i;
    }
}

/// The second mesh can't be refitted, so the first isn't either.
TEST(Scene, refit_that_is_refused_leaves_the_scene_as_it_was) {
    TriangleMesh first = flat_triangle(), second = flat_triangle();
    second.faces.push_back({0, 1, 3});
    second.vertices.push_back(Vec3d::Constant(kNaN));
    std::vector<Vec3f> floats;
    for (const Vec3d& vertex : first.vertices) floats.push_back(vertex.cast<float>());
    Scene scene({MeshViewf{floats, first.faces}, second});
    for (Vec3f& vertex : floats) vertex.x() += 100;
    second.vertices[3] = {0, 0, 1};
    EXPECT_THROW(scene.refit(), InvalidInput);
    EXPECT_EQ(scene.closest_hit({.origin = {0, 0, 5}})->instance, 0u);
    EXPECT_FALSE(scene.any_hit({.origin = {100, 0, 5}}));
    second.vertices[3].setConstant(kNaN);
    scene.refit();
    EXPECT_EQ(scene.closest_hit({.origin = {0, 0, 5}})->instance, 1u);
    EXPECT_TRUE(scene.any_hit({.origin = {100, 0, 5}}));
}

/// Coordinates so large that the rounding of distances shows.
TEST(Scene, spheres_find_what_brute_force_finds_next_to_huge_triangles) {
    Instance far;
    far.to_world.translate(Vec3d(1e19, 0, 0));
    std::size_t touching = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        const auto number = [&](std::uint32_t k) { return uniform(7, seed, k); };
        const double size = std::pow(10.0, 14 + 3 * number(0));
        const TriangleMesh mesh = {.vertices = {{1 + number(1), -size * number(2), size},
                                                {1 + number(3), size, -size * number(4)},
                                                {1 + number(5), -size, -size}},
                                   .faces = {{0, 1, 2}}};
        const Scene scene({mesh}, {Instance(), far}, {});
        const Vec3d center(number(6), number(7), number(8));
        const auto nearest = scene.closest_point(center);
        ASSERT_TRUE(nearest);
        for (const double radius : {nearest->distance, std::nextafter(nearest->distance, 0.0)}) {
            const Sphere3d sphere = {center, radius};
            const auto expected = sphere_overlap_brute_force(MeshView(mesh), sphere);
            ASSERT_EQ(scene.sphere_overlap(sphere).size(), expected.size()) << seed;
            touching += expected.size();
        }
    }
    EXPECT_GT(touching, 2000u);
}

}  // namespace
}  // namespace boxwood
