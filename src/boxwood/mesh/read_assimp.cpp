// SPDX-License-Identifier: Apache-2.0
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <deque>
#include <sstream>
#include <string>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/mesh/assimp.h"
#include "boxwood/mesh/assimp/assimp_files.h"
#include "boxwood/mesh/assimp/assimp_mesh.h"
#include "boxwood/mesh/mesh_assembly.h"
#include "boxwood/mesh/warn_of_vertices.h"

namespace boxwood {

namespace {

AffineMap map_of(const aiMatrix4x4& m) {
    AffineMap map = AffineMap::Identity();
    map.matrix().topRows<3>() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3,
        m.c4;
    return map;
}

/// Puts the meshes of a scene where its nodes have them.
class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::string& file, const Limits& limits)
        : scene_(scene), file_(file), limits_(limits) {}

    MeshData read() {
        std::vector<std::string> materials;
        for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
            materials.emplace_back(scene_.mMaterials[i]->GetName().C_Str());
        for (unsigned i = 0; i < scene_.mNumMeshes; ++i)
            parts_.push_back(mesh_of(*scene_.mMeshes[i], materials, file_, limits_));
        if (scene_.mRootNode) walk(*scene_.mRootNode);
        MeshData mesh = assembly_.finish();
        for (const MeshData& part : parts_) mesh.warnings.append(part.warnings);
        warn_of_vertices(file_, mesh);
        return mesh;
    }

private:
    struct Step {
        const aiNode* node;
        AffineMap above;
        std::uint64_t depth;
    };

    void walk(const aiNode& root) {
        std::vector<Step> steps = {{&root, AffineMap::Identity(), 1}};
        while (!steps.empty()) {
            const Step step = steps.back();
            steps.pop_back();
            if (step.depth > limits_.max_depth)
                throw ParseError(file_, "",
                                 fmt::format("found nodes deeper in one another than {}, expected "
                                             "at most that",
                                             limits_.max_depth));
            const AffineMap to_world = step.above * map_of(step.node->mTransformation);
            for (unsigned i = 0; i < step.node->mNumMeshes; ++i)
                add(step.node->mMeshes[i], to_world, step.node->mName.C_Str());
            for (unsigned i = step.node->mNumChildren; i-- > 0;)
                steps.push_back({step.node->mChildren[i], to_world, step.depth + 1});
        }
    }

    void add(unsigned mesh, const AffineMap& to_world, const std::string& name) {
        const MeshData& part = parts_.at(mesh);
        if (!assembly_.has_room_for(part, limits_))
            throw ParseError(file_, "",
                             fmt::format("found more than {} vertices or {} faces in all, expected "
                                         "at most that",
                                         limits_.max_vertices, limits_.max_faces));
        assembly_.add(part, to_world, name);
    }

    const aiScene& scene_;
    const std::string& file_;
    const Limits& limits_;
    std::vector<MeshData> parts_;
    MeshAssembly assembly_;
};

std::vector<MeshFormat> read_formats(std::deque<std::string>& texts) {
    std::vector<MeshFormat> formats;
    const Assimp::Importer importer;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        const aiImporterDesc* description = importer.GetImporterInfo(i);
        const std::string& name = texts.emplace_back(description->mName);
        std::istringstream extensions(description->mFileExtensions);
        for (std::string extension; extensions >> extension;) {
            const std::string& kept = texts.emplace_back("." + extension);
            formats.push_back({kept, name, parse_by_assimp, nullptr, nullptr});
        }
    }
    return formats;
}

}  // namespace

std::span<const MeshFormat> assimp_formats() {
    static std::deque<std::string> texts;
    static const std::vector<MeshFormat> kFormats = read_formats(texts);
    return kFormats;
}

MeshData parse_by_assimp(const MeshSource& source, const ReadOptions& options) {
    try {
        Assimp::Importer importer;
        auto* const files = new AssimpFiles(source, options);
        importer.SetIOHandler(files);  // which then owns it
        const aiScene* scene = importer.ReadFile(files->main_file(), aiProcess_Triangulate);
        if (!scene)
            throw ParseError(source.name(), "",
                             fmt::format("found what assimp can't read ({}), expected a model",
                                         importer.GetErrorString()));
        MeshData mesh = SceneReader(*scene, source.name(), options.limits).read();
        mesh.warnings.append(files->warnings());
        return mesh;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw ParseError(source.name(), "",
                         fmt::format("assimp failed on the file: {}", error.what()));
    }
}

}  // namespace boxwood
