// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/core/vec.h"

namespace boxwood {

/// For each vertex the name of its position: equal names, equal positions; NaN has names too.
/// O(n log n), all cores.
std::vector<std::uint32_t> weld(std::span<const Vec3d> vertices);

/// For each vertex the first one in the file at the same position, itself for most; -0 is 0, and
/// NaN is no position, so that a vertex with it stays alone. O(n log n), all cores.
std::vector<std::uint32_t> first_at_position(std::span<const Vec3d> vertices);

/// The same from the names that weld() gave.
std::vector<std::uint32_t> first_at_position(std::span<const Vec3d> vertices,
                                             std::span<const std::uint32_t> names);

}  // namespace boxwood
