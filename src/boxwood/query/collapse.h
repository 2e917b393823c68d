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

struct CollapseOptions {
    int width = 16;        ///< 4, 8 or 16 children a node
    float scale = 1;       ///< a power of two by which all coordinates are multiplied
    bool compact = false;  ///< leaves hold each vertex once
    /// Memory that nobody needs any more: the tree is put into it, if it is large enough.
    Arena spare = {};
};

/// Collapses a binary tree; see WideTree.
Collapsed collapse(MeshView mesh, const Tree& tree, CollapseOptions options);

/// The cost that collapse() would tell, in a third of the time.
double collapsed_cost(const Tree& tree, int width);

}  // namespace boxwood
