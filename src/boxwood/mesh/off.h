// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Reads an OFF file: the line "OFF", counts of vertices, faces and (optional) edges, a line a
/// vertex, a line a face. Comments from # to the end of the line and blank lines are skipped,
/// polygons become fans of triangles, colours and normals are ignored. Coordinates must be finite
/// and within the range of float, as the trees' boxes are. O(file size), all cores.
/// Throws ParseError with the line, what was found and what was expected.
MeshData parse_off(const MeshSource& source, const ReadOptions& options = {});

/// Writes an OFF file whose numbers read back exactly. Throws IoError, and InvalidInput on what
/// parse_off would reject: coordinates that aren't finite or beyond the range of float, and indices
/// out of range.
void write_off(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& attributes = {});

}  // namespace boxwood
