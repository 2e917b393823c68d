// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/core/box.h"

namespace boxwood {

/// A node of a binary tree of boxes: an inner node with two children that stand side by side, or a
/// leaf with a range of primitives.
struct Node {
    Box3f box;
    /// Inner node: the index of the left child; the right one follows it. Leaf: the place in
    /// Tree::order of the first primitive.
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< primitives of a leaf; 0 says inner node

    bool is_leaf() const { return count > 0; }
    std::uint32_t left() const { return first; }
    std::uint32_t right() const { return first + 1; }
};

/// As deep as trees may be without Tree::parents.
constexpr std::size_t kDeepestWithoutParents = 80;

/// A binary AABB tree over primitives known by their index: what every builder makes, and what is
/// queried, measured and drawn. The root is node 0; a tree over nothing has no nodes.
struct Tree {
    std::vector<Node> nodes;
    /// The primitives, each at least once; leaves are ranges of it. A permutation, but where a
    /// builder splits primitives: then several leaves may hold one, each with a box around a part,
    /// and a leaf holds none twice.
    std::vector<std::uint32_t> order;
    /// The parent of each node, 0 for the root, if the tree is deeper than kDeepestWithoutParents;
    /// else empty. A query remembers its way back in a shallow tree and looks it up in a deep one,
    /// so that it needs no memory of its own. See add_parents().
    std::vector<std::uint32_t> parents;

    bool is_empty() const { return nodes.empty(); }
    const Node& root() const { return nodes.front(); }
    std::span<const std::uint32_t> primitives(const Node& leaf) const {
        return {order.data() + leaf.first, leaf.count};
    }
};

}  // namespace boxwood
