// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Reads a glTF 2.0 file, .gltf or .glb, as one mesh: the triangles of its scene's nodes where they
/// stand, one node after another; the groups are the nodes. A file without nodes gives its meshes
/// as they are. What it holds besides meshes is for read_gltf_world(). Throws IoError for a file
/// that it names, and ParseError with the JSON path, what was found and what was expected.
MeshData parse_gltf(const MeshSource& source, const ReadOptions& options = {});

/// Writes a .glb, or a .gltf with its data inside. Positions, normals, texture coordinates and
/// colors become those of vertices in float; vertices whose corners differ in them are split. A
/// primitive is made for each run of faces with one material, of which the name is kept. Throws
/// IoError, and InvalidInput on more data than a .glb can hold.
void write_glb(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes);
void write_gltf(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes);

/// Whether write_gltf keeps an attribute.
bool is_held_by_gltf(const AttributeName& attribute);

}  // namespace boxwood
