// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/reinsertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

Box3f cube(float x) { return {Vec3f(x, 0, 0), Vec3f(x + 1, 1, 1)}; }

/// Pairs boxes that are far apart: ((0 100) (1 101)).
Tree bad_tree() {
    const auto both = [](float a, float b) { return merged(cube(a), cube(b)); };
    Tree tree;
    tree.nodes = {{both(0, 101), 1, 0}, {both(0, 100), 3, 0}, {both(1, 101), 5, 0}, {cube(0), 0, 1},
                  {cube(100), 1, 1},    {cube(1), 2, 1},      {cube(101), 3, 1}};
    tree.order = {0, 1, 2, 3};
    return tree;
}

TEST(Reinsertion, pairs_what_is_near) {
    const std::vector<Box3f> boxes = {cube(0), cube(100), cube(1), cube(101)};
    Tree tree = bad_tree();
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    optimize_by_reinsertion(tree, {.largest_part = 1});
    EXPECT_EQ(find_fault(tree, boxes), std::nullopt);
    EXPECT_LT(tree.nodes[tree.root().left()].box.extent().x(), 3);
    EXPECT_LT(tree.nodes[tree.root().right()].box.extent().x(), 3);
}

TEST(Reinsertion, any_tree_stays_valid_and_gets_no_dearer) {
    constexpr int kRounds = kIsSanitized ? 2 : 10;
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        for (const auto& [name, options] : all_builds()) {
            SCOPED_TRACE(family.name + " " + name);
            Tree tree = build_tree(mesh, options);
            const TreeStatistics before = statistics(tree);
            const std::vector<std::uint32_t> order = tree.order;
            optimize_by_reinsertion(tree, {.rounds = kRounds, .largest_part = 1, .least_gain = 0});
            ASSERT_EQ(find_fault(tree, boxes, options.method), std::nullopt);
            const TreeStatistics after = statistics(tree);
            EXPECT_LE(after.sah_cost, before.sah_cost * (1 + 1e-6));
            EXPECT_LE(after.depth, std::max<std::size_t>(before.depth, 80));
            EXPECT_EQ(tree.order, order);
            EXPECT_EQ(after.leaves, before.leaves);
        }
    }
}

TEST(Reinsertion, median_trees_gain_much) {
    const TriangleMesh mesh = generate_soup(5000);
    Tree tree = build_tree(mesh, {.method = BuildMethod::median});
    const double before = statistics(tree).sah_cost;
    optimize_by_reinsertion(tree, {.rounds = 10, .largest_part = 1});
    EXPECT_LT(statistics(tree).sah_cost, 0.9 * before);
}

TEST(Reinsertion, no_round_changes_nothing) {
    const Tree before = build_tree(generate_soup(1000), {.method = BuildMethod::median});
    Tree tree = before;
    optimize_by_reinsertion(tree, {.rounds = 0});
    EXPECT_TRUE(are_identical(tree, before));
}

TEST(Reinsertion, tree_is_the_same_for_any_number_of_threads) {
    const TriangleMesh mesh = generate_soup(30'000);
    const Tree before = build_tree(mesh, {.method = BuildMethod::median});
    std::vector<Tree> trees(3, before);
    for (std::size_t i = 0; i < 3; ++i) {
        const ThreadLimit limit(2 * i + 1);
        optimize_by_reinsertion(trees[i]);
    }
    EXPECT_FALSE(are_identical(trees[0], before));
    EXPECT_TRUE(are_identical(trees[0], trees[1]));
    EXPECT_TRUE(are_identical(trees[0], trees[2]));
}

TEST(Reinsertion, options_out_of_range_are_refused) {
    Tree tree = bad_tree();
    EXPECT_THROW(optimize_by_reinsertion(tree, {.rounds = -1}), InvalidInput);
    EXPECT_THROW(optimize_by_reinsertion(tree, {.largest_part = 1.5}), InvalidInput);
    EXPECT_THROW(optimize_by_reinsertion(tree, {.least_gain = -1}), InvalidInput);
}

}  // namespace
}  // namespace boxwood
