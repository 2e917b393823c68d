// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/gltf/document.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// Adds the textures of a glTF file to the world, one for one. Those that can't be read become
/// white, with a warning.
void add_gltf_textures(const GltfDocument& document, World& world);

/// Adds its materials, one for one, and the one for what has none. Precondition: its textures are
/// the world's. Throws ParseError.
void add_gltf_materials(const GltfDocument& document, World& world);

}  // namespace boxwood
