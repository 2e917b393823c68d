// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// Reads a mesh file in the format that its extension names (.off). Throws InvalidInput on an
/// extension that no reader has, and what the reader throws.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace boxwood
