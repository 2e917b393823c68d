// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/core/box.h"
#include "boxwood/core/separation.h"
#include "boxwood/core/vec.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

// What of a mesh touches a shape: having a point in common counts, the surfaces of box, sphere and
// triangle included. Answers are those of testing every triangle, for every builder, width and
// instruction set. What touches is always found; what is apart by no more than 2^-50 of the size of
// both, along no axis of coordinates, may be. Triangles of zero area are the segments or points
// that they cover; those with a corner that isn't finite or beyond the range of float are never
// found. Precondition: the tree was made from this mesh. About O(log n) for each triangle found.
// Explained in docs/algorithms/overlaps.md.

inline TriangleCorners corners_of(const MeshView& mesh, std::uint32_t triangle) {
    return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}
inline TriangleCorners corners_of(const PlacedMesh& placed, std::uint32_t triangle) {
    return {placed.corner(triangle, 0), placed.corner(triangle, 1), placed.corner(triangle, 2)};
}

struct Sphere3d {
    Vec3d center = Vec3d::Zero();
    double radius = 0;
};

/// A box around all that sphere_overlap() may find where no coordinate is larger than that.
Box3d box_around(const Sphere3d& sphere, double largest);

/// The triangles that touch the box, in order. None where the box is empty or has a NaN.
std::vector<std::uint32_t> box_overlap(MeshView mesh, const WideTree& tree, const Box3d& box);

/// The triangles no farther from the center than the radius, by the distance of closest_point(), in
/// order. None where the radius is negative or NaN, or the center isn't finite or beyond 1e150.
std::vector<std::uint32_t> sphere_overlap(MeshView mesh, const WideTree& tree,
                                          const Sphere3d& sphere);

/// Whether the triangle touches the mesh. It doesn't when a coordinate of it isn't finite
/// or beyond 1e75.
bool triangle_overlap(MeshView mesh, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept;

// The same for a mesh that stands somewhere in the world, by the tree of the mesh where it is.
std::vector<std::uint32_t> box_overlap(const PlacedMesh& placed, const WideTree& tree,
                                       const Box3d& box);
std::vector<std::uint32_t> sphere_overlap(const PlacedMesh& placed, const WideTree& tree,
                                          const Sphere3d& sphere);
bool triangle_overlap(const PlacedMesh& placed, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept;

/// Lists of triangles, one after another: the i-th is from offsets[i] to offsets[i + 1].
template <class Id>
struct TriangleLists {
    std::vector<std::size_t> offsets = {0};
    std::vector<Id> triangles;

    std::span<const Id> operator[](std::size_t i) const {
        return std::span(triangles).subspan(offsets[i], offsets[i + 1] - offsets[i]);
    }
};
using OverlapLists = TriangleLists<std::uint32_t>;

// The same for each shape, on all cores. They throw what BatchOptions says.
OverlapLists box_overlaps(MeshView mesh, const WideTree& tree, std::span<const Box3d> boxes,
                          const BatchOptions& options = {});
OverlapLists sphere_overlaps(MeshView mesh, const WideTree& tree, std::span<const Sphere3d> spheres,
                             const BatchOptions& options = {});
/// Throws InvalidInput when the sizes differ.
void triangle_overlaps(MeshView mesh, const WideTree& tree,
                       std::span<const TriangleCorners> triangles, std::span<bool> results,
                       const BatchOptions& options = {});

}  // namespace boxwood
