// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A random ray of a random kind: from anywhere to anywhere, exactly at a vertex or an edge, along
/// an edge, parallel to axes, from the faces and corners of boxes, and with limits of all sorts. A
/// function of the seed, so that one ray that fails a law can be had again.
Ray random_ray(MeshView mesh, std::uint64_t seed);

}  // namespace boxwood
