// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/mesh/placement.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A mesh somewhere in the world: that with its vertices moved there and rounded, without a copy of
/// it. Refers to the placement, too. The front of a triangle goes with it, even where the placement
/// mirrors.
struct PlacedMesh {
    MeshView mesh;
    const Placement* placement;
    bool culls_back_faces = false;  ///< rays that meet the back of a triangle go on

    Vec3d corner(std::size_t face, int k) const {
        return placement->to_world(mesh.corner(face, k));
    }
};

// What queries ask of a mesh and of a placed one alike: corner(), and these.

inline std::size_t face_count(const MeshView& mesh) { return mesh.faces.size(); }
inline std::size_t face_count(const PlacedMesh& placed) { return placed.mesh.faces.size(); }

/// A triangle that leaves the range of float, here or there, is found by no query.
inline bool is_in_float_range(const PlacedMesh& placed, std::size_t face) {
    bool is_in_range = is_in_float_range(placed.mesh, face);
    for (int k = 0; k < 3; ++k)
        is_in_range &= (placed.corner(face, k).array().abs() <= FLT_MAX).all();
    return is_in_range;
}

/// Whether rays stop at a triangle that they meet from the front, or from behind.
inline bool stops(const MeshView&, bool /*from_front*/) { return true; }
inline bool stops(const PlacedMesh& placed, bool from_front) {
    return !placed.culls_back_faces || from_front != placed.placement->is_mirrored();
}

}  // namespace boxwood
