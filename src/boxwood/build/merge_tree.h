// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/tree/tree.h"

namespace boxwood {

/// A node that was made of two. Of n primitives in some order, the name of the i-th one is i, that
/// of the result of merge k is n + k.
struct Merge {
    std::uint32_t left = 0, right = 0;  ///< names
    std::uint32_t count = 0;            ///< primitives below
    std::uint32_t nodes = 0;            ///< of the subtree, this one included; 1 makes it a leaf
};

/// The tree of n - 1 merges, each after the merges of its parts; primitive names i are order[i].
/// Depth first: a subtree's nodes stand together. O(n), all cores. Its recursion is as deep as the
/// tree.
Tree make_merge_tree(std::span<const Box3f> boxes, std::span<const std::uint32_t> order,
                     std::span<const Merge> merges);

}  // namespace boxwood
