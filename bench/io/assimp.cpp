// SPDX-License-Identifier: Apache-2.0
// Nothing but triangles is asked of assimp: joining vertices or normals would cost it more time.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "boxwood/core/error.h"
#include "io/file_reader.h"

namespace boxwood::bench {

FileInMemory read_by_assimp(const std::filesystem::path& file) {
    auto importer = std::make_shared<Assimp::Importer>();
    const aiScene* scene = importer->ReadFile(file.string(), aiProcess_Triangulate);
    if (!scene) throw Error(file.string() + ": assimp: " + importer->GetErrorString());
    std::size_t triangles = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) triangles += scene->mMeshes[i]->mNumFaces;
    return {std::move(importer), triangles};
}

}  // namespace boxwood::bench
