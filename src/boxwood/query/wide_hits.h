// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

// Queries in float on a wide tree: the answers of closest_hit() and any_hit() for the mesh with
// vertices rounded to float and all arithmetic in float. Watertight. The same bits for every
// builder, width and instruction set.

/// The hit with the least t in [ray.t_min, ray.t_max], equal distances to the lower triangle.
std::optional<Hitf> closest_hit(const WideTree& tree, const Rayf& ray) noexcept;

/// Whether anything is hit in [ray.t_min, ray.t_max].
bool any_hit(const WideTree& tree, const Rayf& ray) noexcept;

}  // namespace boxwood
