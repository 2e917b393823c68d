// SPDX-License-Identifier: Apache-2.0
// A scene of several meshes answers as brute force does, to the last bit, whatever its trees.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "boxwood/query/brute_force.h"
#include "boxwood/scene/scene.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

/// Families that lie about the origin; some twice, so that meshes tie.
std::vector<TriangleMesh> some_meshes() {
    std::vector<TriangleMesh> meshes;
    for (const char* name :
         {"soup", "nothing", "cube", "duplicates", "grid", "icosphere", "duplicates", "only_nan",
          "grid", "with_bad_vertices", "cube", "one_triangle", "with_degenerate_ones"}) {
        const auto& families = mesh_families();
        const auto family = std::find_if(families.begin(), families.end(),
                                         [&](const MeshFamily& f) { return f.name == name; });
        meshes.push_back(family->make());
    }
    return meshes;
}

std::vector<SceneMesh> views(const std::vector<TriangleMesh>& meshes) {
    return {meshes.begin(), meshes.end()};
}

/// The least of all hits on all meshes, without Scene.
std::optional<Hit> closest_hit_of_all(const std::vector<TriangleMesh>& meshes, const Ray& ray) {
    std::optional<Hit> closest;
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        Ray ray_in_mesh = ray;
        if (ray.skip.instance != i) ray_in_mesh.skip = {};
        auto hit = closest_hit_brute_force(meshes[i], ray_in_mesh);
        if (!hit) continue;
        hit->instance = i;
        if (!closest || is_closer(*hit, *closest)) closest = hit;
    }
    return closest;
}

TEST(SceneLaws, queries_equal_brute_force_to_the_last_bit) {
    const std::vector<TriangleMesh> meshes = some_meshes();
    const std::vector<NamedAccelerator> accelerators = all_accelerators();
    std::vector<Scene> scenes;
    for (const NamedAccelerator& accelerator : accelerators)
        scenes.emplace_back(views(meshes), accelerator.options);

    std::size_t hits = 0;
    for (std::uint64_t seed = 0; seed < cases(3000); ++seed) {
        const std::size_t mesh = Random(seed).index(meshes.size());
        Ray ray = random_ray(meshes[mesh], seed);
        if (ray.skip.triangle != TriangleId::kNone)
            ray.skip.instance = static_cast<std::uint32_t>(mesh);
        for (int variant = 0; variant < 3; ++variant) {
            const auto expected = closest_hit_of_all(meshes, ray);
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                const auto found = scenes[i].closest_hit(ray);
                ASSERT_TRUE(are_identical(found, expected))
                    << accelerators[i].name << ", seed " << seed << ", variant " << variant << "\n"
                    << testing::PrintToString(ray) << "\nfound    " << testing::PrintToString(found)
                    << "\nexpected " << testing::PrintToString(expected);
                ASSERT_EQ(scenes[i].any_hit(ray), expected.has_value())
                    << accelerators[i].name << ", seed " << seed << ", variant " << variant;
            }
            if (!expected) break;
            ++hits;
            // On from there: the same triangle of a mesh that is the same may well be hit.
            ray.skip = {expected->instance, expected->triangle};
            if (variant == 1) ray.origin = ray.at(expected->t);
        }
    }
    EXPECT_GT(hits, cases(2000u));
}

TEST(SceneLaws, batches_equal_brute_force_to_the_last_bit) {
    const std::vector<TriangleMesh> meshes = some_meshes();
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    for (std::uint64_t seed = 0; seed < cases(2000); ++seed) {
        rays.push_back(random_ray(meshes[Random(seed).index(meshes.size())], seed));
        expected.push_back(closest_hit_of_all(meshes, rays.back()).value_or(Hit{}));
    }
    for (const NamedAccelerator& accelerator : all_accelerators()) {
        const Scene scene(views(meshes), accelerator.options);
        std::vector<Hit> found(rays.size());
        const auto any = std::make_unique<bool[]>(rays.size());
        scene.closest_hits(rays, found);
        scene.any_hits(rays, {any.get(), rays.size()});
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(are_identical(found[i], expected[i])) << accelerator.name << ", seed " << i;
            ASSERT_EQ(any[i], expected[i].is_hit()) << accelerator.name << ", seed " << i;
        }
    }
}

TEST(SceneLaws, every_family_alone_and_twice_equals_brute_force) {
    for (const MeshFamily& family : mesh_families()) {
        const std::vector<TriangleMesh> meshes(2, family.make());
        for (std::size_t count : {1, 2}) {
            const std::vector<TriangleMesh> chosen(meshes.begin(), meshes.begin() + count);
            const Scene brute(views(chosen), {.brute_force = true});
            const Scene scene(views(chosen));
            for (std::uint64_t seed = 0; seed < cases(300); ++seed) {
                const Ray ray = random_ray(meshes[0], seed);
                const auto expected = brute.closest_hit(ray);
                ASSERT_TRUE(are_identical(scene.closest_hit(ray), expected))
                    << family.name << " " << count << ", seed " << seed;
                ASSERT_EQ(scene.any_hit(ray), expected.has_value()) << family.name << seed;
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
