// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A random point of a random kind: anywhere in and around the mesh, exactly at a vertex, on an
/// edge or in a face, a little or a lot off these, at the same distance from many, far away, and at
/// the origin. A function of the seed. Not always finite where the mesh isn't.
Vec3d random_point(MeshView mesh, std::uint64_t seed);

}  // namespace boxwood
