// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/mesh.h>

#include <string>
#include <vector>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// A triangulated mesh of assimp's as one of ours; the materials of its scene have these names.
/// Throws ParseError, with the file's name, on indices out of range and on what is beyond the
/// limits.
MeshData mesh_of(const aiMesh& mesh, const std::vector<std::string>& materials,
                 const std::string& file, const Limits& limits);

}  // namespace boxwood
