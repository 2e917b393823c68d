// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

struct SpatialSplitOptions {
    std::uint32_t largest_leaf = 4;  ///< triangles, at least 1
    /// A leaf's triangles are tested this many at a time: a leaf of n costs ceil(n / leaf_block).
    std::uint32_t leaf_block = 1;
    double node_cost = 1;   ///< of a step through an inner node ...
    double block_cost = 1;  ///< ... against the test of a block
    /// References to triangles, as a multiple of the triangles, at most; 1 to 4.
    double replication = 1.25;
    /// Triangles are split only where the halves of the best other cut overlap in a box of more
    /// than this part of the root's area.
    double least_overlap = 1e-4;
    /// Where nothing is that large any more, build_block_sah() goes on, with leaves of up to so
    /// many triangles, which is faster; 0: nowhere.
    std::uint32_t block = 0;
    /// How many triangles that follow one another it may take for one there; see run_length().
    std::uint32_t run = 1;
};

/// The builder for scenes with large triangles among small ones: as binned SAH, but where that
/// leaves halves that overlap, space is cut and a triangle may go to both sides. A leaf's box then
/// holds only parts of its triangles; each point of a triangle is in a leaf that has it. A triangle
/// is at most once in a leaf. O(n log n) time, depth at most 41 + log2(replication n), all cores,
/// the same tree for any number of them. Throws InvalidInput on options out of range. Precondition:
/// indices in range.
Tree build_spatial_split(MeshView mesh, const SpatialSplitOptions& options = {});

}  // namespace boxwood
