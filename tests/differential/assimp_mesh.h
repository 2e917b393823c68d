// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace boxwood {

/// A triangle's corners in float.
using Corners = std::array<std::array<float, 3>, 3>;

/// What assimp finds in a file.
struct AssimpMesh {
    std::string error;  ///< empty unless it can't read the file
    std::vector<Corners> triangles = {};
};

/// All triangles of a file's nodes where they stand.
AssimpMesh read_by_assimp(const std::filesystem::path& file);

}  // namespace boxwood
