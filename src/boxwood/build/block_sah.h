// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

struct BlockSahOptions {
    /// Primitives that are tested at once, and the most that a leaf holds; at least 1.
    std::uint32_t block = 16;
    /// From this depth on ranges are halved, so that no input makes a deep tree; at most 40, 0 or
    /// less: from the root on.
    int deepest_sah_split = 40;
};

/// The fast builder for wide trees: binned SAH like build_binned_sah, but a leaf costs one test
/// however full it is, so that cuts go no further than to blocks. O(n log n) time, depth at most
/// max(deepest_sah_split, 1) + ceil(log2 n) whatever the boxes, all cores, the same tree for any
/// number of them. Throws InvalidInput on options out of range.
Tree build_block_sah(std::span<const Box3f> boxes, const BlockSahOptions& options = {});

/// Over the triangle_boxes() of a mesh, without making them first.
Tree build_block_sah(MeshView mesh, const BlockSahOptions& options = {});

}  // namespace boxwood
