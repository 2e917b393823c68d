// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "boxwood/tree/tree.h"

namespace boxwood {

/// What is wrong with a tree over these boxes, one line for the first fault found; nothing when it
/// is valid: each primitive in exactly one leaf, each node reached exactly once, each box the
/// smallest around what is below it, and parents where the tree is deep. O(n).
std::optional<std::string> find_fault(const Tree& tree, std::span<const Box3f> boxes);

/// The same for a tree whose builder may split primitives: each primitive in at least one leaf and
/// at most once in any, each node reached exactly once, each inner box the smallest around its
/// children, each leaf's box within those of its primitives, and the leaves of a primitive together
/// around all of its box. That they leave no hole in it can't be told from boxes. O(n).
std::optional<std::string> find_fault_in_split_tree(const Tree& tree, std::span<const Box3f> boxes);

}  // namespace boxwood
