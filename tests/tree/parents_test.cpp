// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/parents.h"

#include <gtest/gtest.h>

#include <string>

#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"

namespace boxwood {
namespace {

const Box3f kBox = {Vec3f::Zero(), Vec3f::Ones()};

/// Each inner node has a leaf on the left.
Tree chain(std::uint32_t depth) {
    Tree tree;
    tree.nodes = {{kBox, 1, 0}};
    for (std::uint32_t i = 0; i < depth; ++i) {
        tree.nodes.push_back({kBox, i, 1});
        tree.nodes.push_back({kBox, 2 * i + 3, 0});
    }
    tree.nodes.back() = {kBox, depth, 1};
    for (std::uint32_t i = 0; i <= depth; ++i) tree.order.push_back(i);
    return tree;
}

TEST(Parents, deep_trees_have_them_and_shallow_ones_do_not) {
    Tree tree = chain(kDeepestWithoutParents);
    ASSERT_EQ(statistics(tree).depth, kDeepestWithoutParents);
    add_parents(tree);
    EXPECT_TRUE(tree.parents.empty());

    tree = chain(kDeepestWithoutParents + 1);
    const std::size_t bytes = statistics(tree).bytes;
    add_parents(tree);
    ASSERT_EQ(tree.parents.size(), tree.nodes.size());
    EXPECT_EQ(statistics(tree).bytes, bytes + 4 * tree.nodes.size());
    EXPECT_EQ(tree.parents[0], 0u);
    for (std::uint32_t i = 1; i < tree.nodes.size(); ++i)
        EXPECT_EQ(tree.parents[i], (i - 1) / 2 * 2);
    Tree empty;
    add_parents(empty);
    EXPECT_TRUE(empty.parents.empty());
}

TEST(Parents, validation_demands_them) {
    const auto fault = [](const Tree& tree) {
        return find_fault(tree, std::vector<Box3f>(tree.order.size(), kBox)).value_or("none");
    };
    Tree tree = chain(100);
    EXPECT_EQ(fault(tree), "0 parents, expected 201");
    add_parents(tree);
    EXPECT_EQ(fault(tree), "none");
    tree.parents[7] = 3;
    EXPECT_EQ(fault(tree), "node 7 has parent 3, expected 6");
    tree = chain(3);
    EXPECT_EQ(fault(tree), "none");
    tree.parents.resize(7);
    EXPECT_EQ(fault(tree), "7 parents, expected 0");
}

}  // namespace
}  // namespace boxwood
