// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/read_mesh.h"

#include <fmt/format.h>

#include <string>

#include "boxwood/core/error.h"
#include "boxwood/mesh/off.h"

namespace boxwood {

TriangleMesh read_mesh(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    if (extension == ".off") return read_off(path);
    throw InvalidInput(fmt::format("{}: no reader for {}, expected a file name ending in .off",
                                   path.string(),
                                   extension.empty() ? "a file without extension" : extension));
}

}  // namespace boxwood
