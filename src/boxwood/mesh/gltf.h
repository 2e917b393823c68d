// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Reads a glTF 2.0 file, .gltf or .glb, as one mesh: the triangles of its scene's nodes where they
/// stand, one node after another; the groups are the nodes. A file without nodes gives its meshes
/// as they are. What it holds besides meshes is for read_gltf_world(). Throws IoError for a file
/// that it names, and ParseError with the JSON path, what was found and what was expected.
MeshData parse_gltf(const MeshSource& source, const ReadOptions& options = {});

}  // namespace boxwood
