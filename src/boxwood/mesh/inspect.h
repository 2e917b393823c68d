// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// What there is to know about a mesh before tracing rays at it.
struct MeshReport {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    Box3d bounds;
    std::size_t degenerate_faces = 0;   ///< see below
    std::size_t boundary_edges = 0;     ///< edges of one face
    std::size_t nonmanifold_edges = 0;  ///< edges of three faces or more
    std::size_t flipped_edges = 0;      ///< edges that two faces run through in the same direction
    bool closed = false;                ///< has faces, and each edge belongs to exactly two of them
};

/// Faces meet where their vertices have the same position, whatever their indices, so that a soup
/// of triangles is judged as the surface it draws. A face is degenerate when its area is zero, or a
/// corner isn't finite or lies beyond the range of float. The edges of a degenerate face count like
/// any others where its corners are three distinct finite places, as it may well fill a seam; else
/// the face counts as absent: a collapsed face between two whole ones leaves them neighbours.
/// Precondition: indices in range. O(n log n), all cores.
MeshReport inspect(MeshView mesh);

}  // namespace boxwood
