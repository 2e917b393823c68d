// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

// Mesh files in the format that the extension names: .off.

/// Throws InvalidInput on an extension that no reader has, and what the reader throws.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Throws InvalidInput on an extension that no writer has, and what the writer throws.
void write_mesh(const std::filesystem::path& path, MeshView mesh);

}  // namespace boxwood
