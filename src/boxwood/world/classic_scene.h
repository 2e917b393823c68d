// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "boxwood/core/json_reader.h"
#include "boxwood/mesh/mesh_source.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// Reads the scene file of the assignment, the "classic" format, and the meshes it names. The
/// format is described in docs/guide/classic_scene.md and schemas/classic-scene.schema.json. Mesh
/// paths are looked up in the scene file's folder, then in the data folder if one is given; they
/// may lead anywhere. Throws IoError, and ParseError with the JSON path, what was found and what
/// was expected.
World read_classic_scene(const JsonReader& json, const std::filesystem::path& path,
                         const ReadOptions& options = {},
                         const std::filesystem::path& data_folder = {});

/// The same scene as a file of version 2. Throws ParseError as read_classic_scene() does, but
/// doesn't look at the meshes.
std::string upgraded_classic_scene(const JsonReader& json);

}  // namespace boxwood
