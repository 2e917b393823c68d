// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct SweepSahOptions {
    std::uint32_t largest_leaf = 4;  ///< primitives, at least 1
    /// Primitives that are tested at once, at least 1: costs count the blocks that they fill.
    std::uint32_t leaf_block = 1;
    double node_cost = 1;       ///< of a step through an inner node ...
    double primitive_cost = 1;  ///< ... against the test of a block
};

/// The thorough builder: top-down, each split the cheapest by the surface area heuristic among all
/// between centroids along an axis. O(n log n) time, depth at most 40 + log2 n whatever the boxes,
/// all cores, the same tree for any number of them. Throws InvalidInput on options out of range.
Tree build_sweep_sah(std::span<const Box3f> boxes, const SweepSahOptions& options = {});

}  // namespace boxwood
