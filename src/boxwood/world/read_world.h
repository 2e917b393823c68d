// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "boxwood/mesh/mesh_source.h"
#include "boxwood/mesh/repair.h"
#include "boxwood/world/studio.h"
#include "boxwood/world/world.h"

namespace boxwood {

struct WorldOptions {
    ReadOptions read = {};
    /// Where else to look for the meshes that a scene file names; empty for nowhere.
    std::filesystem::path data_folder = {};
    /// For a mesh file; without it y, or z for formats of printers and machines (.stl).
    std::optional<UpAxis> up = {};
    /// What is done about each mesh once it's read.
    std::vector<RepairStep> repair = {};
};

/// Whatever a picture can be made of: a scene file (.json, classic or of version 2), a glTF file,
/// or a mesh file of any format, which is framed and lit as studio.h does. Throws IoError,
/// ParseError, and InvalidInput on an extension that no reader has.
World read_world(const std::filesystem::path& path, const WorldOptions& options = {});

/// A mesh by itself, framed and lit. Its materials, if it has some, are looked up by name.
World world_of_mesh(MeshData mesh, UpAxis up, std::vector<Material> materials = {},
                    std::vector<Texture> textures = {});

}  // namespace boxwood
