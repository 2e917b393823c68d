// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct PlocOptions {
    int radius = 8;                  ///< neighbours looked at on each side, 1 to 32
    std::uint32_t largest_leaf = 4;  ///< primitives, at least 1
    double node_cost = 1;            ///< of a step through an inner node ...
    double primitive_cost = 1;       ///< ... against the test of a primitive
};

/// The fast bottom-up builder, parallel locally-ordered clustering: rounds in which all nodes merge
/// that are each other's best partner, by the area of their union, among their neighbours along a
/// curve through space. O(n log n) time, O(log n) depth, all cores, the same tree for any number of
/// them. Throws InvalidInput on options out of range.
Tree build_ploc(std::span<const Box3f> boxes, const PlocOptions& options = {});

}  // namespace boxwood
