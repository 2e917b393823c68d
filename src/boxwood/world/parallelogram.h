// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// Two triangles on the four corners, counter-clockwise as seen from the tip of u x v.
inline TriangleMesh make_parallelogram(const Vec3d& origin, const Vec3d& u, const Vec3d& v) {
    return {.vertices = {origin, origin + u, origin + u + v, origin + v},
            .faces = {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace boxwood
