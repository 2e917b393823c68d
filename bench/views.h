// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "boxwood/core/box.h"
#include "boxwood/world/camera.h"

namespace boxwood::bench {

/// Two cameras for a mesh of that name. Those of an interior, a stadium and an atrium stand inside
/// of it; of anything else they stand around it and see nearly all of it.
std::vector<Camera> views_of(std::string_view mesh, const Box3d& bounds);

}  // namespace boxwood::bench
