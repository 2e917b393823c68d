// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "boxwood/core/batch.h"
#include "boxwood/query/ray_columns.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_counts.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

// Queries in float on a wide tree: the answers of closest_hit() and any_hit() for the mesh with
// vertices rounded to float and all arithmetic in float. Watertight. The same bits for every
// builder, width and instruction set.

/// The hit with the least t in [ray.t_min, ray.t_max], equal distances to the lower triangle.
std::optional<Hitf> closest_hit(const WideTree& tree, const Rayf& ray) noexcept;
/// The same into a place that is there already, which is faster.
void closest_hit(const WideTree& tree, const Rayf& ray, Hitf& hit) noexcept;

/// Whether anything is hit in [ray.t_min, ray.t_max].
bool any_hit(const WideTree& tree, const Rayf& ray) noexcept;

/// The same for each ray, in order. Runs on all cores; the bits don't depend on that, nor on which
/// rays stand side by side. A camera's rays are fastest in tiles of 256, in order. Throws
/// InvalidInput when the sizes differ, and what BatchOptions says.
void closest_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<Hitf> hits,
                  const BatchOptions& options = {});
void any_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<bool> hits,
              const BatchOptions& options = {});
/// The same where the parts of rays and hits stand in arrays of their own, but for what HitColumns
/// says.
void closest_hits(const WideTree& tree, const RayColumns& rays, const HitColumns& hits,
                  const BatchOptions& options = {});
void any_hits(const WideTree& tree, const RayColumns& rays, std::span<bool> hits,
              const BatchOptions& options = {});

/// The answers of closest_hit() and any_hit(), adding to the counts what the walk did. These have
/// kernels of their own, up to 1.3 times as slow, so that nobody else has to ask who counts.
void closest_hit(const WideTree& tree, const Rayf& ray, Hitf& hit, WideCounts& counts) noexcept;
bool any_hit(const WideTree& tree, const Rayf& ray, WideCounts& counts) noexcept;

}  // namespace boxwood
