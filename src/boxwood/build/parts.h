// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "boxwood/tree/tree.h"

namespace boxwood {

/// A part of a tree that one task builds: its nodes, root first; or a root alone, and what is below
/// it in parts of their own.
struct TreePart {
    std::vector<Node> nodes = std::vector<Node>(1);
    std::unique_ptr<TreePart> left, right;
};

/// All nodes in one array, part behind part.
std::vector<Node> joined(TreePart part);

}  // namespace boxwood
