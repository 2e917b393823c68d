// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/traverse.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// The hit with the least t in [ray.t_min, ray.t_max], from either side, edges and vertices
/// included; equal distances go to the lower triangle. Exactly the answer of brute force, whatever
/// the tree. Triangles with a corner that isn't finite are never hit, and neither is
/// ray.skip.triangle. About O(log n).
/// Precondition: a valid tree over the mesh's triangles.
std::optional<Hit> closest_hit(MeshView mesh, const Tree& tree, const Ray& ray,
                               TraversalCounts* counts = nullptr) noexcept;

/// The same for a mesh that stands somewhere in the world, by the tree of the mesh where it is.
std::optional<Hit> closest_hit(const PlacedMesh& placed, const Tree& tree, const Ray& ray,
                               TraversalCounts* counts = nullptr) noexcept;

}  // namespace boxwood
