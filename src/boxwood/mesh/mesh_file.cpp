// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/mesh_file.h"

#include <fmt/format.h>

#include <string>

#include "boxwood/core/error.h"
#include "boxwood/mesh/off.h"

namespace boxwood {

namespace {

std::string lower_case_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

InvalidInput unknown_format(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    return InvalidInput(fmt::format("{}: found {}, expected a mesh file that ends in .off",
                                    path.string(),
                                    extension.empty() ? "a name without extension" : extension));
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
    if (lower_case_extension(path) == ".off") return read_off(path);
    throw unknown_format(path);
}

void write_mesh(const std::filesystem::path& path, MeshView mesh) {
    if (lower_case_extension(path) == ".off") return write_off(path, mesh);
    throw unknown_format(path);
}

}  // namespace boxwood
