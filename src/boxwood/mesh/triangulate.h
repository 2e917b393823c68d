// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/core/vec.h"

namespace boxwood {

/// A polygon that was read as the fan of triangles around its first corner: (0, 1, 2), (0, 2, 3)
/// and so on, from first_face on.
struct PolygonFan {
    std::size_t first_face;
    std::uint32_t corners;  ///< at least 4
};

/// No polygon of more corners than this is clipped; its fan stays.
constexpr std::uint32_t kMostClippedCorners = 1024;

/// Cuts those polygons again, by clipping ears, whose fan doesn't cover them, as that of a concave
/// one may not; that of a polygon that crosses itself stays. The number of triangles stays. The
/// arrays are the faces and whatever else has three indices a face, for its corners: all are
/// reordered alike. Returns the number of fans that are wrong and stay because of their size. O(n)
/// for n corners in fans, about O(n^2) for each polygon that is clipped, and O(n^3) at the most;
/// all cores. Preconditions: indices in range, fans in order and apart. Source: Meisters, "Polygons
/// have ears", American Mathematical Monthly 82, 1975.
std::size_t mend_fans(std::span<const Vec3d> vertices, std::span<const PolygonFan> fans,
                      std::vector<Vec3i>& faces, std::span<std::vector<Vec3i>* const> others = {});

}  // namespace boxwood
