// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// What there is to know about a mesh before tracing rays at it.
struct MeshReport {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    Box3d bounds;

    std::size_t nonfinite_vertices = 0;
    std::size_t duplicate_vertices = 0;     ///< at the position of an earlier one
    std::size_t unreferenced_vertices = 0;  ///< corners of no face

    std::size_t degenerate_faces = 0;  ///< see below
    std::size_t duplicate_faces = 0;   ///< with the corners of an earlier one, in whatever order

    std::size_t boundary_edges = 0;     ///< edges of one face
    std::size_t boundary_loops = 0;     ///< connected sets of those
    std::size_t nonmanifold_edges = 0;  ///< edges of three faces or more
    std::size_t flipped_edges = 0;      ///< edges that two faces run through in the same direction
    bool closed = false;                ///< has faces, and each edge belongs to exactly two of them

    std::size_t components = 0;    ///< sets of faces that are joined at vertices
    double area = 0;               ///< of all faces whose corners are within the range of float
    std::optional<double> volume;  ///< inside, when closed and no edge is flipped
};

/// Faces meet where their vertices have the same position, whatever their indices, so that a soup
/// of triangles is judged as the surface it draws. A face is degenerate when its area is zero, or a
/// corner isn't finite or lies beyond the range of float. The edges of a degenerate face count like
/// any others where its corners are three distinct finite places, as it may well fill a seam; else
/// the face counts as absent: a collapsed face between two whole ones leaves them neighbours.
/// Area and volume don't depend on the number of threads.
/// Precondition: indices in range. O(n log n), all cores.
MeshReport inspect(MeshView mesh);

/// MeshReport::closed alone, in half the time or less.
bool is_closed(MeshView mesh);

}  // namespace boxwood
