// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "boxwood/core/warnings.h"
#include "boxwood/mesh/mesh_source.h"
#include "boxwood/world/material.h"
#include "boxwood/world/texture.h"

namespace boxwood {

/// The materials of an OBJ file's material library.
struct MtlLibrary {
    std::vector<Material> materials;
    std::vector<Texture> textures;  ///< that they use
    Warnings warnings;
};

/// Reads an .mtl file: newmtl, Kd, Ks, Ns, Ke, d or Tr, Ni and map_Kd, with its pictures. The
/// ambient color is the diffuse one, whatever Ka says, as exporters write anything there. What
/// isn't read, and pictures that can't be, are told by the warnings. Throws ParseError with the
/// line.
MtlLibrary parse_mtl(const MeshSource& source, const ReadOptions& options = {});

}  // namespace boxwood
