// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood::bench {

/// A mesh in one format.
struct SampleFile {
    std::string format;  ///< "PLY, text"
    bool is_text;
    std::filesystem::path path;
};

/// Writes a mesh into a folder in every format that is measured: text with the numbers as they are,
/// binary in float as most programs write it, and binary PLY in double as well. Throws IoError.
std::vector<SampleFile> write_samples(const std::filesystem::path& folder, MeshView mesh);

}  // namespace boxwood::bench
