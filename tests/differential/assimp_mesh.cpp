// SPDX-License-Identifier: Apache-2.0
// Assimp works in a process of its own: an assertion of Debian's build, or a count that asks for
// more memory than there is, ends only that.
#include "differential/assimp_mesh.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/Importer.hpp>
#include <cstdio>
#include <exception>
#include <memory>

namespace boxwood {

namespace {

void add_meshes(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above,
                std::vector<Corners>& triangles) {
    const aiMatrix4x4 placement = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;  // points and lines
            Corners corners;
            for (unsigned k = 0; k < 3; ++k) {
                const aiVector3D p = placement * mesh.mVertices[mesh.mFaces[f].mIndices[k]];
                corners[k] = {p.x, p.y, p.z};
            }
            triangles.push_back(corners);
        }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        add_meshes(scene, *node.mChildren[i], placement, triangles);
}

AssimpMesh read_here(const std::filesystem::path& file) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
    if (!scene || !scene->mRootNode) return {std::string("says ") + importer.GetErrorString()};
    AssimpMesh result;
    add_meshes(*scene, *scene->mRootNode, aiMatrix4x4(), result.triangles);
    return result;
}

[[noreturn]] void read_and_tell(const std::filesystem::path& file, std::FILE* told) {
    constexpr rlim_t kMemory = rlim_t{2} << 30;
    const rlimit limit{kMemory, kMemory};
    setrlimit(RLIMIT_AS, &limit);
    std::fclose(stderr);
    try {
        const AssimpMesh mesh = read_here(file);
        const std::size_t count = mesh.triangles.size();
        std::fwrite(&count, sizeof count, 1, told);
        std::fwrite(mesh.triangles.data(), sizeof(Corners), count, told);
        std::fwrite(mesh.error.data(), 1, mesh.error.size(), told);
    } catch (const std::exception& error) {
        _exit(1);
    }
    std::fflush(told);
    _exit(0);
}

}  // namespace

AssimpMesh read_by_assimp(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> told(std::tmpfile(), std::fclose);
    if (!told) return {"no temporary file"};
    const pid_t child = fork();
    if (child == 0) read_and_tell(file, told.get());
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return {"no process"};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {"fails"};
    std::rewind(told.get());
    AssimpMesh mesh;
    std::size_t count = 0;
    if (std::fread(&count, sizeof count, 1, told.get()) != 1) return {"tells nothing"};
    mesh.triangles.resize(count);
    if (std::fread(mesh.triangles.data(), sizeof(Corners), count, told.get()) != count)
        return {"tells too little"};
    for (int c = std::fgetc(told.get()); c != EOF; c = std::fgetc(told.get()))
        mesh.error += static_cast<char>(c);
    return mesh;
}

}  // namespace boxwood
