// SPDX-License-Identifier: Apache-2.0
// The parts of inspect(): each fills in some of the report. The names are those of weld().
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/mesh/inspect.h"

namespace boxwood {

using PositionNames = std::span<const std::uint32_t>;

/// Vertices that aren't finite, that share a position, or that no face has.
void inspect_vertices(MeshView mesh, PositionNames names, MeshReport& report);
/// Degenerate and duplicate faces, components.
void inspect_faces(MeshView mesh, PositionNames names, MeshReport& report);
/// Boundary, non-manifold and flipped edges, and whether the surface is closed.
void inspect_edges(MeshView mesh, PositionNames names, MeshReport& report);
/// Area, and volume where the edges allow it.
void measure(MeshView mesh, MeshReport& report);

}  // namespace boxwood
