// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "boxwood/core/arena.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// The memory of a wide tree, laid out as query/wide_node.h says, and its expected cost.
struct Collapsed {
    Arena memory;
    double cost = 0;
    int stack_size = 0;  ///< places that a walk needs at most to remember nodes
    /// Triangles that have no place in it, as a corner is not finite or beyond the range of float;
    /// in order.
    std::vector<std::uint32_t> left_out;
};

/// Collapses a binary tree to nodes of 4, 8 or 16 children, with all coordinates multiplied by a
/// power of two, and with compact leaves or not; see WideTree.
Collapsed collapse(MeshView mesh, const Tree& tree, int width, float scale, bool compact);

/// The cost that collapse() would tell, in a third of the time.
double collapsed_cost(const Tree& tree, int width);

}  // namespace boxwood
