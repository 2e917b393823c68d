// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "boxwood/core/point_triangle.h"
#include "boxwood/core/vec.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// Normals that tell on which side of a closed mesh a point is, wherever the closest point lies: on
/// an edge the sum of both triangles' normals, at a corner that of all, each weighed by its angle.
/// Triangles meet where their corners have the same position. Refers to the mesh's arrays, which
/// must outlive it and stay as they are. O(n log n) to make; 12 bytes a triangle and 24 a vertex.
/// Source: Baerentzen and Aanaes, "Signed Distance Computation Using the Angle Weighted
/// Pseudonormal", IEEE TVCG 11(3), 2005. Explained in docs/algorithms/signed_distance.md.
class Pseudonormals {
public:
    /// Precondition: indices in range.
    explicit Pseudonormals(MeshView mesh);

    /// Whether each edge belongs to two triangles that run through it in opposite directions.
    bool is_consistent() const { return is_consistent_; }

    /// Of any length. Nothing where a triangle takes part whose area is so small that it has none,
    /// nor, on a consistent mesh, where triangles lean over each other by more than a right angle:
    /// a fold that simplification left may stick through the surface, with its inside out.
    std::optional<Vec3d> at(std::uint32_t triangle, TrianglePart part) const noexcept;

private:
    void find_neighbours(const std::vector<std::uint32_t>& names);
    void add_up_corners(const std::vector<std::uint32_t>& names);
    bool leans_over_neighbour(std::uint32_t triangle) const;

    MeshView mesh_;
    bool is_consistent_ = false;
    std::vector<std::array<std::uint32_t, 3>> neighbours_;  ///< across ab, bc and ca
    std::vector<Vec3d> at_vertex_;                          ///< zero where there is none
    std::vector<std::uint8_t> is_folded_;  ///< 1 for a triangle that leans over a neighbour
};

}  // namespace boxwood
