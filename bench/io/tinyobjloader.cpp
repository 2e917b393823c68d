// SPDX-License-Identifier: Apache-2.0
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "boxwood/core/error.h"
#include "io/file_reader.h"

namespace boxwood::bench {

FileInMemory read_by_tinyobjloader(const std::filesystem::path& file) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    auto reader = std::make_shared<tinyobj::ObjReader>();
    if (!reader->ParseFromFile(file.string(), config))
        throw Error(file.string() + ": tinyobjloader: " + reader->Error());
    std::size_t triangles = 0;
    for (const tinyobj::shape_t& shape : reader->GetShapes())
        triangles += shape.mesh.num_face_vertices.size();
    return {std::move(reader), triangles};
}

}  // namespace boxwood::bench
