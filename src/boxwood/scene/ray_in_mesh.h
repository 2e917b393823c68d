// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "boxwood/core/ray.h"

namespace boxwood {

/// The ray as a mesh of the scene sees it.
inline Ray ray_in_mesh(Ray ray, std::uint32_t mesh) {
    if (ray.skip.mesh != mesh) ray.skip = {};
    return ray;
}

}  // namespace boxwood
