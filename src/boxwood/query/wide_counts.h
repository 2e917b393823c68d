// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace boxwood {

/// What single rays did on a wide tree, summed over rays. Explained in
/// docs/algorithms/wide_tree.md.
struct WideCounts {
    std::uint64_t nodes = 0;      ///< visited; the root by every ray that has to look at all
    std::uint64_t boxes = 0;      ///< tested: the children of those nodes, without empty slots
    std::uint64_t blocks = 0;     ///< visited
    std::uint64_t triangles = 0;  ///< tested: those in the blocks, without empty slots
    /// 64 bytes of the tree each, of which a visit reads something: of a node the boxes, the
    /// children if any is hit, their order if it is asked for; of a block the corners, and the
    /// indices if the closest hit may be there; of a compact block all. Counted a visit, so a line
    /// that two visits share, as they can where the width is 4, or 8 in a compact tree, counts
    /// twice. The ray's own memory doesn't count.
    std::uint64_t lines = 0;
};

}  // namespace boxwood
