// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

struct AttributeName;

/// Reads an STL file, binary or text. Triangles share no vertices: face i has 3 i, 3 i + 1 and
/// 3 i + 2; repair() welds them. A file is binary when its size is what its count of triangles
/// says, even if it begins with "solid"; else text is what begins so and has no control characters.
/// Facet normals only serve to warn of those that point to the back. The binary format's attribute
/// bytes become the field "attribute" of faces unless all are 0; the names of solids in text become
/// groups when there are several. O(file size), all cores.
/// Throws ParseError with the line or byte, what was found and what was expected.
MeshData parse_stl(const MeshSource& source, const ReadOptions& options = {});

// The two halves of parse_stl.
MeshData parse_binary_stl(const MeshSource& source, const ReadOptions& options);
MeshData parse_stl_text(const MeshSource& source, const ReadOptions& options);

/// Writes a binary STL file. The format has floats: coordinates are rounded to them, and normals
/// are those of the rounded triangles. A field "attribute" of faces is kept where its values are
/// whole and fit 16 bits, and left out otherwise. Throws IoError, and InvalidInput on indices out
/// of range and on more triangles than 32 bits count.
void write_stl(const std::filesystem::path& path, MeshView mesh,
               const MeshAttributes& attributes = {});

/// Whether write_stl keeps an attribute.
bool is_held_by_stl(const AttributeName& attribute);

}  // namespace boxwood
