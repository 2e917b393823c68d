// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// Whether a ray from the point crosses the mesh an odd number of times: whether a closed mesh
/// holds the point, whichever way its triangles face. A ray that meets an edge, a corner or two
/// triangles in one place tells nothing, and others are tried; no answer when all of them do. On
/// the surface either answer. O(log n) for each crossing. Precondition: the tree was made from this
/// mesh.
std::optional<bool> is_inside_by_parity(MeshView mesh, const WideTree& tree,
                                        const Vec3d& point) noexcept;

}  // namespace boxwood
