// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/statistics.h"

#include <gtest/gtest.h>

namespace boxwood {
namespace {

Box3f box(float x_lo, float x_hi) { return {Vec3f(x_lo, 0, 0), Vec3f(x_hi, 1, 1)}; }

TEST(Statistics, tree_made_by_hand_is_counted) {
    // Five primitives: a leaf of three at depth 1, leaves of one at depth 2.
    Tree tree;
    tree.nodes = {{box(0, 4), 1, 0},
                  {box(0, 1), 0, 3},
                  {box(2, 4), 3, 0},
                  {box(2, 3), 3, 1},
                  {box(3, 4), 4, 1}};
    tree.order = {4, 3, 2, 1, 0};
    const TreeStatistics found = statistics(tree);
    EXPECT_EQ(found.nodes, 5u);
    EXPECT_EQ(found.leaves, 3u);
    EXPECT_EQ(found.depth, 2u);
    EXPECT_EQ(found.largest_leaf, 3u);
    EXPECT_EQ(found.bytes, 5 * sizeof(Node) + 5 * sizeof(std::uint32_t));
    // Areas: root 18, leaf of three 6, inner 10, leaves 6 and 6.
    EXPECT_DOUBLE_EQ(found.sah_cost, (18 + 3 * 6 + 10 + 6 + 6) / 18.0);
}

TEST(Statistics, empty_tree_has_nothing) {
    const TreeStatistics found = statistics({});
    EXPECT_EQ(found.nodes, 0u);
    EXPECT_EQ(found.leaves, 0u);
    EXPECT_EQ(found.depth, 0u);
    EXPECT_EQ(found.largest_leaf, 0u);
    EXPECT_EQ(found.bytes, 0u);
    EXPECT_EQ(found.sah_cost, 0);
}

TEST(Statistics, root_that_is_a_leaf_has_depth_0_and_costs_its_primitives) {
    Tree tree;
    tree.nodes = {{box(0, 1), 0, 4}};
    tree.order = {0, 1, 2, 3};
    const TreeStatistics found = statistics(tree);
    EXPECT_EQ(found.depth, 0u);
    EXPECT_EQ(found.sah_cost, 4);
}

TEST(Statistics, root_without_area_costs_nothing) {
    Tree tree;
    tree.nodes = {{{Vec3f::Ones(), Vec3f::Ones()}, 0, 1}};
    tree.order = {0};
    EXPECT_EQ(statistics(tree).sah_cost, 0);
    tree.nodes[0].box = {};
    EXPECT_EQ(statistics(tree).sah_cost, 0);
}

TEST(Statistics, node_is_32_bytes) { EXPECT_EQ(sizeof(Node), 32u); }

}  // namespace
}  // namespace boxwood
