// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/bound_depth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boxwood/tree/parents.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"

namespace boxwood {
namespace {

/// Boxes in a row.
std::vector<Box3f> row(std::uint32_t count) {
    std::vector<Box3f> boxes(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3f place(static_cast<float>(i), 0, 0);
        boxes[i] = {place, place + Vec3f::Ones()};
    }
    return boxes;
}

/// A leaf to the left of each inner node, all others to the right.
Tree chain(const std::vector<Box3f>& boxes) {
    const auto count = static_cast<std::uint32_t>(boxes.size());
    Tree tree;
    tree.nodes.resize(2 * boxes.size() - 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        tree.order.push_back(i);
        Box3f rest;
        for (std::uint32_t k = i; k < count; ++k) rest.extend(boxes[k]);
        const std::uint32_t inner = 2 * i;
        if (i + 1 == count) {
            tree.nodes[inner] = {boxes[i], i, 1};
        } else {
            tree.nodes[inner] = {rest, inner + 1, 0};
            tree.nodes[inner + 1] = {boxes[i], i, 1};
        }
    }
    add_parents(tree);
    return tree;
}

TEST(BoundDepth, a_chain_becomes_as_flat_as_asked_and_keeps_its_leaves) {
    const std::vector<Box3f> boxes = row(500);
    const Tree deep = chain(boxes);
    ASSERT_EQ(find_fault(deep, boxes), std::nullopt);
    ASSERT_EQ(statistics(deep).depth, 499u);
    Tree flat = bound_depth(deep, 20);
    EXPECT_EQ(find_fault(flat, boxes), std::nullopt);
    EXPECT_LE(statistics(flat).depth, 20u + 9u);
    EXPECT_EQ(statistics(flat).leaves, 500u);
    EXPECT_EQ(flat.order, deep.order);
}

TEST(BoundDepth, a_flat_tree_stays_as_it_is) {
    const std::vector<Box3f> boxes = row(8);
    const Tree tree = chain(boxes);
    const Tree same = bound_depth(tree, 20);
    EXPECT_EQ(find_fault(same, boxes), std::nullopt);
    EXPECT_EQ(statistics(same).depth, statistics(tree).depth);
    EXPECT_TRUE(bound_depth({}, 20).is_empty());
}

}  // namespace
}  // namespace boxwood
