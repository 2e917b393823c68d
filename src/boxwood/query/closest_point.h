// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "boxwood/core/batch.h"
#include "boxwood/core/point_triangle.h"
#include "boxwood/core/ray.h"
#include "boxwood/core/vec.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// The place on a mesh that is nearest to a point.
struct ClosestPoint {
    double distance = std::numeric_limits<double>::infinity();  ///< in units of the coordinates
    Vec3d point = Vec3d::Zero();  ///< (1 - u - v) a + u b + v c on the triangle (a, b, c)
    double u = 0, v = 0;
    std::uint32_t triangle = TriangleId::kNone;
    std::uint32_t instance = 0;              ///< of a scene
    TrianglePart part = TrianglePart::face;  ///< of the triangle, where the point lies

    bool is_found() const { return triangle != TriangleId::kNone; }
};

/// Equal distances go to the lower (instance, triangle).
inline bool is_closer(const ClosestPoint& a, const ClosestPoint& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return a.instance != b.instance ? a.instance < b.instance : a.triangle < b.triangle;
}

/// The place on the mesh nearest to the point, if there is one within max_radius, that included;
/// equal distances go to the lowest triangle. Exactly the answer of brute force, for every builder,
/// width and instruction set. A triangle of zero area counts as the segment or point that it
/// covers; one with a corner that isn't finite or beyond the range of float is never found. Nothing
/// is found either for a point with a coordinate that isn't finite or beyond 1e150, or a max_radius
/// that is negative or NaN. About O(log n); O(n) from more than 10^5 times the mesh's size away.
/// Precondition: the tree was made from this mesh. Explained in docs/algorithms/closest_point.md.
std::optional<ClosestPoint> closest_point(
    MeshView mesh, const WideTree& tree, const Vec3d& point,
    double max_radius = std::numeric_limits<double>::infinity()) noexcept;
/// The same for a mesh that stands somewhere in the world, by the tree of the mesh where it is.
std::optional<ClosestPoint> closest_point(
    const PlacedMesh& placed, const WideTree& tree, const Vec3d& point,
    double max_radius = std::numeric_limits<double>::infinity()) noexcept;

/// The same for each point, in order; one that finds nothing gets a ClosestPoint{}. Runs on all
/// cores, in an order of its own that doesn't show in the results, with a few megabytes of memory.
/// Throws InvalidInput when the sizes differ, and what BatchOptions says.
void closest_points(MeshView mesh, const WideTree& tree, std::span<const Vec3d> points,
                    std::span<ClosestPoint> results,
                    double max_radius = std::numeric_limits<double>::infinity(),
                    const BatchOptions& options = {});

}  // namespace boxwood
