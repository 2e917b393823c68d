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

}  // namespace boxwood
