// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/mesh_source.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// A glTF 2.0 file, .gltf or .glb, as a world: its nodes' meshes as objects with their materials
/// and textures, the first of its cameras and its lights. Without a camera it is framed, without
/// lights it is lit as studio.h does. What Phong's terms make of metal and roughness is described
/// in docs/guide/gltf.md. Throws what parse_gltf() throws; what a picture can do without, such as a
/// texture that can't be read, is told by the world's warnings.
World parse_gltf_world(const MeshSource& source, const ReadOptions& options = {});

}  // namespace boxwood
