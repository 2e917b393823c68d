// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood::bench {

/// The vertices and faces of an OBJ file, polygons cut into fans; everything else is passed over.
/// Throws IoError, and ParseError on a face that isn't one.
TriangleMesh read_obj(const std::filesystem::path& path);

}  // namespace boxwood::bench
