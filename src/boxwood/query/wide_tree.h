// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxwood/core/box.h"
#include "boxwood/core/simd.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_memory.h"
#include "boxwood/query/wide_node.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

struct WideTreeOptions {
    /// Decides the width, and which kernels walk the tree. Precondition: is_supported().
    InstructionSet instruction_set = preferred_instruction_set();
    /// Leaves hold each vertex once: half the memory, for rays that take longer.
    bool compact = false;
};

/// What a wide tree consists of. Who changes it keeps to what its readers rely on.
struct WideTreeParts {
    InstructionSet instruction_set = InstructionSet::scalar;
    WideMemory memory;  ///< as query/wide_node.h and query/wide_layout.h say
    bool is_compact = false;
    int stack_size = 0;  ///< places that a walk needs at most to remember nodes
    Box3f bounds;
    float scale = 1;
    bool has_exact_corners = false;
    double cost = 0;
    double cost_at_build = 0;  ///< the same before anything was refitted
    std::size_t faces = 0;     ///< of the mesh
    /// Triangles that have no place in the tree, as a corner wasn't finite or was beyond the range
    /// of float when it was built; in order.
    std::vector<std::uint32_t> left_out;
};

/// The power of two that a tree with these bounds has as its scale.
float scale_for(const Box3f& bounds);

/// What WideTree::has_exact_corners() says of a tree of this scale. O(n), all cores.
bool has_exact_corners(MeshView mesh, float scale);

/// The fast form of a tree over the triangles of a mesh: nodes with 4, 8 or 16 children, and leaves
/// with copies of the triangles in float. It refers to nothing else. What its queries see is the
/// mesh with vertices rounded to float.
class WideTree {
public:
    WideTree() = default;
    /// Collapses the binary tree so that the expected cost of a ray is least. Triangles with a
    /// corner that isn't finite, or beyond the range of float, are left out. O(n), all cores.
    /// Memory that nobody needs any more serves for the tree, if it is large enough, else goes.
    /// Preconditions: a valid tree over the mesh's triangles, no leaf of more than `width` of them.
    WideTree(MeshView mesh, const Tree& tree, const WideTreeOptions& options = {},
             Arena spare = {});

    explicit WideTree(WideTreeParts parts);
    const WideTreeParts& parts() const { return parts_; }
    /// Leaves an empty tree.
    WideTreeParts release();

    int width() const { return lanes(parts_.instruction_set); }
    InstructionSet instruction_set() const { return parts_.instruction_set; }
    bool is_compact() const { return parts_.is_compact; }
    /// Whether nothing in it can be hit.
    bool is_empty() const { return view_.bytes == 0; }
    std::size_t bytes() const { return parts_.memory.size(); }
    const Box3f& bounds() const { return parts_.bounds; }
    /// The power of two by which all coordinates are multiplied in the tree: 1 but for meshes so
    /// small or so large that float arithmetic on them would lose digits or overflow.
    float scale() const { return parts_.scale; }
    /// Whether the corners in the leaves are the mesh's own: all its vertices are floats, and the
    /// scale is 1.
    bool has_exact_corners() const { return parts_.has_exact_corners; }
    /// What a random line through the bounds is expected to cost, in node visits.
    double cost() const { return parts_.cost; }

    /// The middle of the bounds, and how far from it a ray may start in each coordinate to be near:
    /// less than four diagonals in all.
    const Vec3d& middle() const { return middle_; }
    double near_size() const { return near_size_; }

    /// What kernels walk: the root is at its start. No bytes where the tree is empty.
    const WideTreeView& view() const { return view_; }

private:
    WideTreeParts parts_;
    WideTreeView view_;
    Vec3d middle_ = Vec3d::Zero();
    double near_size_ = 0;
};

}  // namespace boxwood
