// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/world/world.h"

namespace boxwood {

/// Reads the scene file of the assignment, the "classic" format, and the meshes it names. The
/// format is described in docs/guide/classic_scene.md and schemas/classic-scene.schema.json. Mesh
/// paths are looked up in the scene file's folder, then in the data folder if one is given.
/// Throws IoError, and ParseError with the JSON path, what was found and what was expected.
World read_classic_scene(const std::filesystem::path& path,
                         const std::filesystem::path& data_folder = {});

}  // namespace boxwood
