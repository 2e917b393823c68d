// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "boxwood/core/named.h"
#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// What can be done about a mesh.
enum class RepairStep { weld, drop_degenerate, orient };

/// What they are called: "weld", "drop-degenerate", "orient".
std::span<const Named<RepairStep>> repair_steps();

/// What was done.
struct RepairReport {
    std::size_t welded_vertices = 0;  ///< gone, as others have their positions
    std::size_t dropped_faces = 0;    ///< gone, as degenerate
    std::size_t flipped_faces = 0;    ///< turned around
    std::size_t unorientable_components =
        0;  ///< where that left flipped edges, as on a Moebius strip
};

/// Takes the steps in the order given. The same result for any number of threads.
/// Preconditions: indices in range, and what check_attributes() wants. Each O(n log n).
RepairReport repair(MeshData& mesh, std::span<const RepairStep> steps);

/// Vertices of equal position become one, the first of them in the file. -0 is 0; NaN is no
/// position. Where vertices that become one differ in a normal, texture coordinates, a colour or a
/// field, those of all vertices become those of corners, and vertices of no face have none. Returns
/// how many vertices went.
std::size_t weld_vertices(MeshData& mesh);

/// Drops the faces that inspect() calls degenerate: of zero area, or with a corner that isn't
/// finite or lies beyond the range of float. What faces and corners have follows; vertices stay.
/// Returns how many faces went.
std::size_t drop_degenerate_faces(MeshData& mesh);

/// Turns faces around such that neighbours run through their common edge in opposite directions,
/// where edges are between positions and neighbours share an edge with no third face. Closed
/// components then get a positive volume, and of others as few faces as can be are turned. Faces
/// without three distinct finite corners stay as they are. Returns the counts of faces turned and
/// of components where it can't be done.
RepairReport orient_faces(MeshData& mesh);

}  // namespace boxwood
