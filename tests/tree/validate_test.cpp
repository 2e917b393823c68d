// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace boxwood {
namespace {

Box3f box(float x_lo, float x_hi) { return {Vec3f(x_lo, 0, 0), Vec3f(x_hi, 1, 1)}; }

const std::vector<Box3f> kBoxes = {box(0, 1), box(1, 2), box(5, 6), box(7, 9)};

/// Root 0 over leaf 1 (primitives 1, 0) and inner node 2 over leaves 3 and 4.
Tree valid_tree() {
    Tree tree;
    tree.nodes = {{box(0, 9), 1, 0},
                  {box(0, 2), 0, 2},
                  {box(5, 9), 3, 0},
                  {box(5, 6), 2, 1},
                  {box(7, 9), 3, 1}};
    tree.order = {1, 0, 2, 3};
    return tree;
}

struct Corruption {
    std::string what;
    std::function<void(Tree&)> corrupt;
    std::string fault;  ///< part of what is reported
};

TEST(Validate, valid_trees_have_no_fault) {
    EXPECT_EQ(find_fault(valid_tree(), kBoxes), std::nullopt);
    EXPECT_EQ(find_fault({}, {}), std::nullopt);
}

TEST(Validate, each_kind_of_fault_is_found) {
    const float nan = std::nanf("");
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<Corruption> corruptions = {
        {"no nodes", [](Tree& t) { t.nodes.clear(); }, "no nodes over 4 primitives"},
        {"short order", [](Tree& t) { t.order.pop_back(); }, "3 primitives in the order"},
        {"long order", [](Tree& t) { t.order.push_back(3); }, "5 primitives in the order"},
        {"unknown primitive", [](Tree& t) { t.order[2] = 4; }, "unknown primitive 4"},
        {"enormous primitive", [](Tree& t) { t.order[2] = 0xffffffff; }, "unknown primitive"},
        {"primitive twice", [](Tree& t) { t.order[0] = 0; }, "primitive 0 is in two leaves"},
        {"leaves overlap", [](Tree& t) { t.nodes[1].count = 3; }, "primitive 2 is in two leaves"},
        {"leaf too short", [](Tree& t) { t.nodes[1].count = 1; }, "isn't tight"},
        {"leaf beyond", [](Tree& t) { t.nodes[4].count = 2; }, "leaf 4 ends beyond"},
        {"leaf overflows", [](Tree& t) { t.nodes[4].first = 0xffffffff; }, "leaf 4 ends beyond"},
        {"children beyond", [](Tree& t) { t.nodes[2].first = 4; }, "node 2 has children beyond"},
        {"children overflow", [](Tree& t) { t.nodes[2].first = 0xffffffff; },
         "node 2 has children"},
        {"cycle", [](Tree& t) { t.nodes[2].first = 1; }, ""},
        {"cycle of the root", [](Tree& t) { t.nodes[0].first = 0; }, "node 0 has two parents"},
        {"node not reached",
         [](Tree& t) {
             t.nodes.push_back({box(0, 1), 0, 1});
         },
         "5 of 6 nodes are reached"},
        {"root too large", [](Tree& t) { t.nodes[0].box.hi.y() = 2; }, "box of node 0 isn't tight"},
        {"root too small", [](Tree& t) { t.nodes[0].box.lo.x() = 1; }, "box of node 0 isn't tight"},
        {"leaf box too large", [](Tree& t) { t.nodes[3].box.lo.x() = 4; }, "isn't tight"},
        {"leaf box too small", [](Tree& t) { t.nodes[3].box.hi.z() = 0.5f; }, "isn't tight"},
        {"box by a bit", [](Tree& t) { t.nodes[4].box.hi.x() = std::nextafter(9.0f, 10.0f); },
         "isn't tight"},
        {"NaN box", [=](Tree& t) { t.nodes[2].box.lo.y() = nan; }, "isn't tight"},
        {"infinite box", [=](Tree& t) { t.nodes[2].box.hi.y() = infinity; }, "isn't tight"},
        {"empty box", [](Tree& t) { t.nodes[2].box = {}; }, "isn't tight"},
    };
    for (const auto& [what, corrupt, fault] : corruptions) {
        Tree tree = valid_tree();
        corrupt(tree);
        const auto found = find_fault(tree, kBoxes);
        ASSERT_TRUE(found) << what;
        EXPECT_NE(found->find(fault), std::string::npos) << what << ": " << *found;
    }
}

TEST(Validate, primitive_in_no_leaf_is_found) {
    // Both leaves hold the same box, so that nothing but the count tells.
    const std::vector<Box3f> boxes = {box(0, 1), box(0, 1), box(0, 1)};
    Tree tree;
    tree.nodes = {{box(0, 1), 1, 0}, {box(0, 1), 0, 1}, {box(0, 1), 1, 1}};
    tree.order = {0, 1, 2};
    EXPECT_EQ(find_fault(tree, boxes), "2 of 3 primitives are in leaves");
}

TEST(Validate, tree_over_other_boxes_is_found) {
    std::vector<Box3f> boxes = kBoxes;
    boxes[3] = box(7, 8);
    EXPECT_TRUE(find_fault(valid_tree(), boxes));
    boxes.push_back(box(0, 1));
    EXPECT_TRUE(find_fault(valid_tree(), boxes));
    EXPECT_TRUE(find_fault({}, boxes));
    EXPECT_TRUE(find_fault(valid_tree(), {}));
}

TEST(Validate, empty_boxes_are_primitives_like_others) {
    const std::vector<Box3f> boxes = {{}, box(0, 1)};
    Tree tree;
    tree.nodes = {{box(0, 1), 1, 0}, {{}, 0, 1}, {box(0, 1), 1, 1}};
    tree.order = {0, 1};
    EXPECT_EQ(find_fault(tree, boxes), std::nullopt);
}

/// Primitive 0 is in both leaves, in two parts that meet at x = 1.
Tree split_tree() {
    Tree tree;
    tree.nodes = {{box(0, 3), 1, 0}, {box(0, 1), 0, 1}, {box(1, 3), 1, 2}};
    tree.order = {0, 1, 0};
    return tree;
}
const std::vector<Box3f> kSplitBoxes = {box(0, 2), box(2, 3)};

TEST(Validate, valid_split_trees_have_no_fault) {
    EXPECT_EQ(find_fault_in_split_tree(split_tree(), kSplitBoxes), std::nullopt);
    EXPECT_EQ(find_fault_in_split_tree(valid_tree(), kBoxes), std::nullopt);
    EXPECT_EQ(find_fault_in_split_tree({}, {}), std::nullopt);
}

TEST(Validate, each_kind_of_fault_in_split_trees_is_found) {
    const std::vector<Corruption> corruptions = {
        {"no nodes", [](Tree& t) { t.nodes.clear(); }, "no nodes over 2 primitives"},
        {"unknown primitive", [](Tree& t) { t.order[1] = 2; }, "unknown primitive 2"},
        {"primitive twice in a leaf", [](Tree& t) { t.order[1] = 0; }, "holds primitive 0 twice"},
        {"primitive in no leaf",
         [](Tree& t) {
             t.order[1] = 0;
             t.nodes[2] = {box(1, 2), 1, 1};
             t.nodes[0].box = box(0, 2);
             t.order.pop_back();
         },
         "primitive 1 is in no leaf"},
        {"leaves overlap", [](Tree& t) { t.nodes[1].count = 2; }, "is in two leaves"},
        {"leaf too short", [](Tree& t) { t.nodes[2].count = 1; }, "larger than its"},
        {"leaf beyond", [](Tree& t) { t.nodes[2].count = 3; }, "ends beyond"},
        {"children beyond", [](Tree& t) { t.nodes[0].first = 2; }, "children beyond"},
        {"cycle", [](Tree& t) { t.nodes[0].first = 0; }, ""},
        {"root too large", [](Tree& t) { t.nodes[0].box.hi.y() = 2; }, "isn't tight"},
        {"leaf too large", [](Tree& t) { t.nodes[2].box.hi.x() = t.nodes[0].box.hi.x() = 4; },
         "larger than its primitives"},
        {"part missing", [](Tree& t) { t.nodes[1].box.lo.x() = t.nodes[0].box.lo.x() = 0.5f; },
         "primitive 0 sticks out"},
    };
    for (const auto& [what, corrupt, fault] : corruptions) {
        Tree tree = split_tree();
        corrupt(tree);
        const auto found = find_fault_in_split_tree(tree, kSplitBoxes);
        ASSERT_TRUE(found) << what;
        EXPECT_NE(found->find(fault), std::string::npos) << what << ": " << *found;
    }
}

}  // namespace
}  // namespace boxwood
