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

}  // namespace boxwood
