// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// An edge of a face between two positions, by their names, as weld() gives them.
struct FaceEdge {
    std::uint64_t ends;  ///< both names, the lower one in the upper half
    std::uint32_t face;
    std::uint8_t side;  ///< from corner side of the face to the next
    bool is_upward;     ///< runs from the lower name to the higher
};

/// Whether the face has three corners at distinct places that boxes of floats can hold. Else it has
/// no edges and counts as absent.
inline bool has_edges(const MeshView& mesh, std::span<const std::uint32_t> names,
                      std::size_t face) {
    const Vec3i& f = mesh.faces[face];
    const std::uint32_t a = names[f[0]], b = names[f[1]], c = names[f[2]];
    return a != b && b != c && c != a && is_in_float_range(mesh, face);
}

/// The edges of all faces that have some, those between the same positions side by side, then by
/// face. O(n log n), all cores.
std::vector<FaceEdge> sorted_face_edges(MeshView mesh, std::span<const std::uint32_t> names);

}  // namespace boxwood
