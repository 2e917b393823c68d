// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/refit.h"

#include <gtest/gtest.h>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/validate.h"

namespace boxwood {
namespace {

/// Four leaves under three inner nodes, children in front of their parents.
Tree small_tree(std::span<const Box3f> boxes) {
    Tree tree;
    tree.order = {3, 2, 1, 0};
    tree.nodes.resize(7);
    for (std::uint32_t i = 0; i < 4; ++i) {
        tree.nodes[i + 1].first = i;
        tree.nodes[i + 1].count = 1;
        tree.nodes[i + 1].box = boxes[tree.order[i]];
    }
    tree.nodes[5].first = 1;
    tree.nodes[6].first = 3;
    tree.nodes[0].first = 5;
    for (const int i : {5, 6, 0})
        tree.nodes[i].box =
            merged(tree.nodes[tree.nodes[i].left()].box, tree.nodes[tree.nodes[i].right()].box);
    return tree;
}

TEST(TreeRefit, boxes_are_the_smallest_around_what_has_moved) {
    std::vector<Box3f> boxes = triangle_boxes(generate_soup(4));
    Tree tree = small_tree(boxes);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vec3f move(static_cast<float>(i), 1, -2);
        boxes[i].lo += move;
        boxes[i].hi += move;
    }
    ASSERT_NE(find_fault(tree, boxes), std::nullopt);
    refit(tree, boxes);
    EXPECT_EQ(find_fault(tree, boxes), std::nullopt);
    Tree nothing;
    refit(nothing, {});
    EXPECT_TRUE(nothing.is_empty());
}

}  // namespace
}  // namespace boxwood
