// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct MortonOptions {
    std::uint32_t largest_leaf = 4;  ///< primitives, at least 1
    /// Cells of few leaves are cut where that leaves full ones: a quarter less memory, for rays
    /// that take a little longer.
    bool full_leaves = false;
    /// Memory to sort in, if it has 16 bytes a primitive and is aligned to 8; else the builder
    /// takes some.
    std::span<std::byte> scratch = {};
};

/// The fastest builder, for what moves: splits space, not the primitives, at the middle of ever
/// smaller cells. O(n log n) time, near O(n) on meshes; depth at most 63 + log2 n whatever the
/// boxes; all cores, the same tree for any number of them. Throws InvalidInput on leaves of 0.
Tree build_morton(std::span<const Box3f> boxes, const MortonOptions& options = {});

}  // namespace boxwood
