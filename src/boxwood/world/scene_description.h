// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/core/json_reader.h"
#include "boxwood/mesh/mesh_source.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// Reads a scene file of version 2, with the files that it includes and the meshes and textures
/// that it names. The format is described in docs/guide/scene.md and schemas/scene-2.schema.json.
/// Meshes are looked up in the scene's folder, then in the data folder if one is given. Throws
/// IoError, and ParseError with the JSON path, what was found and what was expected.
World read_scene_description(const JsonReader& json, const std::filesystem::path& path,
                             const ReadOptions& options = {},
                             const std::filesystem::path& data_folder = {});

}  // namespace boxwood
