// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

// Queries in double precision on a tree in float. The tree is walked in float, with bounds on all
// that rounding can do; what it can't leave out is decided in double from the mesh's own vertices.
// The answers are those of brute force to the last bit, for every builder, width and instruction
// set. Precondition: the tree was made from this mesh.

/// closest_hit() of query/closest_hit.h.
std::optional<Hit> closest_hit(MeshView mesh, const WideTree& tree, const Ray& ray) noexcept;

/// The same, faster, with the hit written to its place: Hit{} where there is none.
void closest_hit(MeshView mesh, const WideTree& tree, const Ray& ray, Hit& hit) noexcept;

/// any_hit() of query/any_hit.h.
bool any_hit(MeshView mesh, const WideTree& tree, const Ray& ray) noexcept;

/// How many rays the functions below take up at a time; fewer are slower each.
constexpr std::size_t kCertifiedAtATime = 2048;

/// The same for each ray, Hit{} where there is none, on this thread: up to 2.4 times as fast as one
/// by one, a camera's rays in tiles as closest_hits() of query/wide_hits.h likes them.
/// Precondition: as many places as rays.
void closest_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                  std::span<Hit> hits) noexcept;
void any_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
              std::span<bool> hits) noexcept;

// The same for a mesh that stands somewhere in the world, by the tree of the mesh where it is: to
// the last bit what the mesh would answer if its vertices were moved there. Explained in
// docs/algorithms/instances.md.
std::optional<Hit> closest_hit(const PlacedMesh& placed, const WideTree& tree,
                               const Ray& ray) noexcept;
bool any_hit(const PlacedMesh& placed, const WideTree& tree, const Ray& ray) noexcept;

}  // namespace boxwood
