// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/mesh_file.h"
#include "io/file_reader.h"

namespace boxwood::bench {

namespace {

bool reads_all(std::string_view) { return true; }
[[maybe_unused]] bool reads_obj(std::string_view extension) { return extension == ".obj"; }

FileInMemory read_by_boxwood(const std::filesystem::path& file) {
    auto mesh = std::make_shared<const MeshData>(read_mesh(file));
    const std::size_t triangles = mesh->faces.size();
    return {std::move(mesh), triangles};
}

}  // namespace

std::vector<FileReader> file_readers() {
    return {
        {"boxwood", 0, reads_all, read_by_boxwood},
        {"boxwood", 1, reads_all, read_by_boxwood},
#ifdef BOXWOOD_BENCH_ASSIMP
        {"assimp", 1, reads_all, read_by_assimp},
#endif
#ifdef BOXWOOD_BENCH_TINYOBJLOADER
        {"tinyobjloader", 1, reads_obj, read_by_tinyobjloader},
#endif
    };
}

}  // namespace boxwood::bench
