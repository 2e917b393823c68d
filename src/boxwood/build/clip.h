// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/build/reference.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A float box around every point of the triangle that lies in the given box and in the slab
/// from <= coordinate <= to along the axis, whatever is rounded: no such point is outside. Hence
/// the result is empty only where there are none. Never larger than the given box. Preconditions:
/// the triangle is finite; the slab's faces are, too.
WideBox clipped_box(MeshView mesh, std::uint32_t triangle, const WideBox& within, int axis,
                    float from, float to);

}  // namespace boxwood
