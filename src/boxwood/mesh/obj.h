// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Reads a Wavefront OBJ file: vertices as they stand, polygons as triangles, normals and texture
/// coordinates, colours behind coordinates, the groups (g and o) and materials of faces, and the
/// names of the files that define those. Normals and texture coordinates belong to corners, or to
/// vertices where each corner has the same index for both. Lines, points, curves, smoothing groups
/// and what isn't known are skipped, all but smoothing groups with warnings. O(file size), all
/// cores. Throws ParseError with the line, what was found and what was expected.
MeshData parse_obj(const MeshSource& source, const ReadOptions& options = {});

/// Writes an OBJ file whose numbers read back exactly. Values of faces become values of corners;
/// colours of faces or corners, and fields, are left out. In names, what would end or change them
/// (control characters, blanks at an end, a comment's start) is written as "_". Throws IoError, and
/// InvalidInput on indices out of range.
void write_obj(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& attributes = {});

/// Whether write_obj keeps an attribute.
bool is_held_by_obj(const AttributeName& attribute);

}  // namespace boxwood
