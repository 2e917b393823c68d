// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct BinnedSahOptions {
    int bins = 16;                   ///< along each axis, 2 to 32
    std::uint32_t largest_leaf = 4;  ///< primitives, at least 1
    double node_cost = 1;            ///< of a step through an inner node ...
    double primitive_cost = 1;       ///< ... against the test of a primitive
};

/// The default builder: top-down, each split the cheapest by the surface area heuristic among the
/// borders of equally wide bins. O(n log n) time, depth at most 40 + log2 n whatever the boxes, all
/// cores, the same tree for any number of them. Throws InvalidInput on options out of range.
Tree build_binned_sah(std::span<const Box3f> boxes, const BinnedSahOptions& options = {});

}  // namespace boxwood
