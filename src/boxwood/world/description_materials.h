// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/core/json_reader.h"
#include "boxwood/world/description_files.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// A material of a scene file of version 2; its textures are added to the world. Throws ParseError,
/// and IoError for a texture's file.
Material read_description_material(const JsonReader& json, const DescriptionFiles& files,
                                   const std::filesystem::path& folder, World& world);

}  // namespace boxwood
