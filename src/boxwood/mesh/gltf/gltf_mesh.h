// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "boxwood/mesh/gltf/document.h"
#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// Mesh i of a glTF file, the triangles of all its primitives one after another. Its normals,
/// colours and first texture coordinates are those of the vertices; where some primitives have them
/// and others don't, these get zeros, or white. Labels of materials are indices of the file's
/// materials, the last one for none. Primitives of points and lines are left out, with a warning.
/// Throws ParseError.
MeshData read_gltf_mesh(const GltfDocument& document, std::size_t i);

}  // namespace boxwood
