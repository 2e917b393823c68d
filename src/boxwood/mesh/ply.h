// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Reads a PLY file, as text or binary of either byte order: vertices, faces (polygons as
/// triangles), tristrips, normals, colours, texture coordinates of vertices and corners. Whatever
/// else is one number for each vertex or face becomes a field. As text, each element has a line.
/// Other elements and lists are skipped, with warnings. O(file size), all cores. Throws ParseError
/// with the line or byte, what was found and what was expected.
MeshData parse_ply(const MeshSource& source, const ReadOptions& options = {});

/// Writes a binary PLY file whose numbers read back exactly: as float where all of a kind are
/// floats, else as double; colours as bytes where they are whole 255ths. Values of corners other
/// than texture coordinates, normals of faces, groups and materials are left out. What can't be in
/// a field's name becomes "_". Throws IoError, and InvalidInput on indices out of range.
void write_ply(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& attributes = {});

/// Whether write_ply keeps an attribute.
bool is_held_by_ply(const AttributeName& attribute);

}  // namespace boxwood
