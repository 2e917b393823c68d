// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct TreeStatistics {
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t depth = 0;         ///< inner nodes above the deepest leaf
    std::size_t largest_leaf = 0;  ///< primitives
    std::size_t bytes = 0;
    /// The surface area heuristic: boxes plus triangles that a random line through the root's box
    /// is expected to test, a node's step and a triangle's test costing 1 each.
    double sah_cost = 0;
};

/// How many nodes are above each one. O(n).
std::vector<std::uint32_t> node_depths(const Tree& tree);

/// O(n). Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", The
/// Visual Computer 6, 1990.
TreeStatistics statistics(const Tree& tree);

}  // namespace boxwood
