// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

struct AttributeName;

/// Reads an OFF file of any variant, [ST][C][N][4][n]OFF as text or BINARY: the keyword, counts of
/// vertices, faces and (optional) edges, a line a vertex, a line a face. Comments from # to the end
/// of the line and blank lines are skipped. Vertices may have normals (N), colours (C) and texture
/// coordinates (ST), in this order, and a fourth coordinate that divides the others (4); a
/// dimension (n) must be 3. Colours are from 0 to 1, or to 255 when any number of them in the file
/// is 2 or more. Faces have theirs only when all faces have and vertices have none. Polygons become
/// triangles. O(file size), all cores.
/// Throws ParseError with the line or byte, what was found and what was expected.
MeshData parse_off(const MeshSource& source, const ReadOptions& options = {});

/// Writes an OFF file whose numbers read back exactly, with normals, colours and texture
/// coordinates of vertices or colours of faces. Colours are held to 0 to 1. Throws IoError, and
/// InvalidInput on indices out of range.
void write_off(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& attributes = {});

/// Whether write_off keeps an attribute.
bool is_held_by_off(const AttributeName& attribute);

}  // namespace boxwood
