// SPDX-License-Identifier: Apache-2.0
// What holds for every builder and every mesh: the tree is valid, queries on it answer as brute
// force does, to the last bit, and it is the same for any number of threads.
#include <gtest/gtest.h>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/any_hit.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

constexpr std::uint64_t kRays = cases(4000);

class TreeLaws : public testing::TestWithParam<MeshFamily> {
protected:
    const TriangleMesh mesh_ = GetParam().make();
};

TEST_P(TreeLaws, tree_is_valid) {
    for (const auto& [name, options] : all_builds()) {
        SCOPED_TRACE(name);
        const Tree tree = build_tree(mesh_, options);
        EXPECT_EQ(find_fault(tree, triangle_boxes(mesh_), options.method), std::nullopt);
        EXPECT_EQ(statistics(tree).nodes, tree.nodes.size());
    }
}

TEST_P(TreeLaws, queries_equal_brute_force_to_the_last_bit) {
    const std::vector<NamedBuild> builds = all_builds();
    std::vector<Tree> trees;
    for (const NamedBuild& build : builds) trees.push_back(build_tree(mesh_, build.options));

    std::size_t hits = 0;
    for (std::uint64_t seed = 0; seed < kRays; ++seed) {
        Ray ray = random_ray(mesh_, seed);
        // Again to where it hit and from there on: limits and skips that matter.
        for (int variant = 0; variant < 4; ++variant) {
            const auto expected = closest_hit_brute_force(mesh_, ray);
            const bool expected_any = any_hit_brute_force(mesh_, ray);
            EXPECT_EQ(expected_any, expected.has_value()) << "seed " << seed;
            hits += expected_any;
            for (std::size_t i = 0; i < builds.size(); ++i) {
                const auto found = closest_hit(mesh_, trees[i], ray);
                ASSERT_TRUE(are_identical(found, expected))
                    << builds[i].name << ", seed " << seed << ", variant " << variant << "\n"
                    << testing::PrintToString(ray) << "\nfound    " << testing::PrintToString(found)
                    << "\nexpected " << testing::PrintToString(expected);
                ASSERT_EQ(any_hit(mesh_, trees[i], ray), expected_any)
                    << builds[i].name << ", seed " << seed << ", variant " << variant << "\n"
                    << testing::PrintToString(ray);
            }
            if (!expected) break;
            switch (variant) {
                case 0:
                    ray.t_max = expected->t;
                    break;
                case 1:
                    ray.skip = {0, expected->triangle};
                    break;
                default:
                    ray.t_max = std::numeric_limits<double>::infinity();
                    ray.t_min = expected->t;
            }
        }
    }
    RecordProperty("hits", static_cast<int>(hits));
}

TEST_P(TreeLaws, rays_that_are_none_hit_nothing) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::vector<Ray> rays = {
        {.origin = {kNaN, 0, 0}},
        {.origin = {0, kInfinity, 0}},
        {.direction = {0, 0, 0}},
        {.direction = {0, kNaN, 1}},
        {.direction = {0, 0, -kInfinity}},
        {.direction = {0, 0, 1e-200}},
        {.direction = {0, 0, 1e200}},
        {.t_min = 2, .t_max = 1},
        {.t_min = kNaN},
        {.t_max = kNaN},
    };
    for (const auto& [name, options] : all_builds()) {
        const Tree tree = build_tree(mesh_, options);
        for (const Ray& ray : rays) {
            EXPECT_FALSE(closest_hit(mesh_, tree, ray)) << name << testing::PrintToString(ray);
            EXPECT_FALSE(any_hit(mesh_, tree, ray)) << name << testing::PrintToString(ray);
        }
    }
}

TEST_P(TreeLaws, tree_is_the_same_for_any_number_of_threads) {
    for (const auto& [name, options] : all_builds()) {
        SCOPED_TRACE(name);
        std::vector<Tree> trees;
        for (const std::size_t threads : {1, 2, 5}) {
            const ThreadLimit limit(threads);
            trees.push_back(build_tree(mesh_, options));
        }
        EXPECT_TRUE(are_identical(trees[0], trees[1]));
        EXPECT_TRUE(are_identical(trees[0], trees[2]));
    }
}

INSTANTIATE_TEST_SUITE_P(Families, TreeLaws, testing::ValuesIn(mesh_families()),
                         [](const auto& instance) { return instance.param.name; });

/// Large enough for many tasks, and for some under a sanitizer.
TEST(TreeLawsOfLargeMeshes, tree_is_valid_and_the_same_for_any_number_of_threads) {
    const std::vector<std::pair<std::string, TriangleMesh>> meshes = {
        {"soup", generate_soup(kIsSanitized ? 20'000 : 40'000)},
        {"grid", flat_grid(kIsSanitized ? 100 : 150)},
        {"terrain", generate_terrain(kIsSanitized ? 15'000 : 30'000)},
        {"one_point", moved(generate_soup(kIsSanitized ? 10'000 : 20'000), 0, Vec3d::Ones())},
    };
    for (const auto& [mesh_name, mesh] : meshes) {
        for (const auto& [method_name, method] : build_methods()) {
            if (method == BuildMethod::agglomerative) continue;  // takes quadratic time
            SCOPED_TRACE(mesh_name + " " + std::string(method_name));
            std::vector<Tree> trees;
            for (const std::size_t threads : {1, 2, 5}) {
                const ThreadLimit limit(threads);
                trees.push_back(build_tree(mesh, {.method = method}));
            }
            EXPECT_TRUE(are_identical(trees[0], trees[1]));
            EXPECT_TRUE(are_identical(trees[0], trees[2]));
            EXPECT_EQ(find_fault(trees[0], triangle_boxes(mesh), method), std::nullopt);
        }
    }
}

}  // namespace
}  // namespace boxwood
