// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/core/arena.h"
#include "boxwood/core/box.h"
#include "boxwood/core/simd.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_node.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

struct WideTreeOptions {
    /// Decides the width, and which kernels walk the tree. Precondition: is_supported().
    InstructionSet instruction_set = preferred_instruction_set();
    /// Leaves hold each vertex once: half the memory, for rays that take longer.
    bool compact = false;
};

/// The fast form of a tree over the triangles of a mesh: nodes with 4, 8 or 16 children, and leaves
/// with copies of the triangles in float. It refers to nothing else. What its queries see is the
/// mesh with vertices rounded to float.
class WideTree {
public:
    WideTree() = default;
    /// Collapses the binary tree so that the expected cost of a ray is least. Triangles with a
    /// corner that isn't finite, or beyond the range of float, are left out. O(n), all cores.
    /// Preconditions: a valid tree over the mesh's triangles, no leaf of more than `width` of them.
    WideTree(MeshView mesh, const Tree& tree, const WideTreeOptions& options = {});

    int width() const { return lanes(instruction_set_); }
    InstructionSet instruction_set() const { return instruction_set_; }
    bool is_compact() const { return view_.is_compact; }
    bool is_empty() const { return memory_.size() == 0; }
    std::size_t bytes() const { return memory_.size(); }
    const Box3f& bounds() const { return bounds_; }
    /// The power of two by which all coordinates are multiplied in the tree: 1 but for meshes so
    /// small or so large that float arithmetic on them would lose digits or overflow.
    float scale() const { return scale_; }
    /// What a random line through the bounds is expected to cost, in node visits.
    double cost() const { return cost_; }

    /// What kernels walk: the root is at its start.
    const WideTreeView& view() const { return view_; }

private:
    InstructionSet instruction_set_ = InstructionSet::scalar;
    Arena memory_;
    WideTreeView view_;
    Box3f bounds_;
    float scale_ = 1;
    double cost_ = 0;
};

}  // namespace boxwood
