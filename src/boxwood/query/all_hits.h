// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/hit_lists.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

// Every place where a ray goes through the surface, in double, from either side: one hit for each
// crossing. A ray through an edge or a vertex crosses there as a ray would that passes infinitely
// near by, on a side that depends on its direction alone (core/ray_crossing.h). So where a surface
// goes on beyond the edge there is one hit, on one of the triangles; where the ray only touches a
// fold there are two hits or none; and a triangle seen exactly edge-on has none. Lines cross closed
// meshes an even number of times. Each hit is one that closest_hit() would accept for its triangle,
// but what that finds first may be an edge that is only touched here.
//
// Answers are those of brute force to the last bit, for every builder, width and instruction set.
// Limits and ray.skip as for closest_hit(). About O(log n) for each crossing. Precondition: the
// tree was made from this mesh. Explained in docs/algorithms/all_hits.md.

/// The crossings with t in [ray.t_min, ray.t_max], in the order of t; equal t in that of triangles.
std::vector<Hit> all_hits(MeshView mesh, const WideTree& tree, const Ray& ray);

/// Their number.
std::size_t count_hits(MeshView mesh, const WideTree& tree, const Ray& ray);

/// Those that are first, as many as there are places: their number, and Hit{} in the places left.
/// The walk ends where none can come first any more. O(places) for each crossing that is found.
std::size_t first_k_hits(MeshView mesh, const WideTree& tree, const Ray& ray,
                         std::span<Hit> hits) noexcept;

// The same for each ray, in order and to the last bit, on all cores. They throw InvalidInput when
// the sizes differ, Cancelled when options.cancellation asks for it; what is in counts and hits
// then is of no use.

/// While at work it takes two and a quarter times the memory of the lists.
HitLists all_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                  const BatchOptions& options = {});
/// As many counts as rays.
void count_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                std::span<std::size_t> counts, const BatchOptions& options = {});
/// A row of k places for each ray, one after another.
void first_k_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays, std::size_t k,
                  std::span<Hit> hits, const BatchOptions& options = {});

}  // namespace boxwood
