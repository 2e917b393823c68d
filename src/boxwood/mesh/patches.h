// SPDX-License-Identifier: Apache-2.0
// Scenes made of curved and flat patches, each cut as finely as a count of triangles allows.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A function over the unit square, cut into columns * rows quads of two triangles each. Its front
/// is the side from which u to v turns counter-clockwise.
struct Patch {
    int columns = 1;
    int rows = 1;
    std::function<Vec3d(double u, double v)> point;
};

/// What a patch is cut into at a level of detail: about scale * detail, at least the least. The
/// phase in [0, 1) decides at which details it grows, so that equal things don't all grow at once.
int pieces(double detail, double scale, int least, double phase);

/// The patches of a scene at a level of detail.
using PatchScene = std::function<std::vector<Patch>(double detail)>;

/// The scene at the detail that has about so many triangles, or at its coarsest.
std::vector<Patch> with_triangles(const PatchScene& scene, std::size_t triangles);

/// O(n), all cores. Columns that end where they began share their vertices by position alone.
TriangleMesh tessellated(const std::vector<Patch>& patches);

// What the patches of scenes are made of.

/// A flat quad with corners at o, o + a, o + a + b and o + b.
Patch flat_patch(const Vec3d& o, const Vec3d& a, const Vec3d& b, int columns = 1, int rows = 1);

/// The six sides of a box with one corner at o and edges a, b, c, a right-handed frame.
void add_box(const Vec3d& o, const Vec3d& a, const Vec3d& b, const Vec3d& c,
             std::vector<Patch>& patches);

/// A profile of (radius, height), both functions of v with rising height, turned around the
/// vertical through the base; the front is outside.
Patch turned_patch(const Vec3d& base, int columns, int rows,
                   std::function<Vec2d(double v)> profile);

/// A tube around a curve in the plane of the directions x and y.
Patch tube_patch(int columns, int rows, std::function<Vec3d(double v)> curve,
                 std::function<Vec3d(double v)> normal, const Vec3d& binormal,
                 std::function<double(double v)> radius);

}  // namespace boxwood
