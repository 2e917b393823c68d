// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// What the moves have made of a tree: WideTree::cost() when it was built and now.
struct RefitQuality {
    double cost_at_build = 0;
    double cost = 0;

    /// 1 as built. About the most that a new tree can win, less where triangles themselves have
    /// grown: below 1.3 it seldom pays. See docs/algorithms/refit.md.
    double ratio() const { return cost_at_build > 0 ? cost / cost_at_build : 1; }
};

/// Fits the tree to a mesh whose vertices have moved and whose faces are the same. All answers are
/// then those of a new tree over it, to the last bit; only how long they take depends on how far
/// things moved. Triangles may become ones that no query hits, by a corner that isn't finite or
/// beyond the range of float, and come back; but those that were like this when the tree was built
/// have no place in it and must stay so. O(n), all cores. A tree from a file moves to memory first.
///
/// Throws InvalidInput, and leaves the tree as it was, when the mesh has another number of faces,
/// an index out of range, or a finite triangle that has no place. That faces are others can't be
/// told in general. Where a compact tree has no room for them, it throws InvalidInput as well and
/// leaves an empty tree. Source: van den Bergen, "Efficient Collision Detection of Complex
/// Deformable Models using AABB Trees", Journal of Graphics Tools 2(4), 1997.
RefitQuality refit(WideTree& tree, MeshView moved);

/// Throws the InvalidInput that refit() does before it changes anything.
void check_refit(const WideTree& tree, MeshView moved);
/// All else that it does. Precondition: check_refit() threw nothing.
RefitQuality refit_checked(WideTree& tree, MeshView moved);

}  // namespace boxwood
