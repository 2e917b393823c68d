// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/assimp/assimp_mesh.h"

#include <fmt/format.h>

#include <utility>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

void read_faces(const aiMesh& mesh, const std::string& file, MeshData& result) {
    result.faces.reserve(mesh.mNumFaces);
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
        if (face.mNumIndices != 3) {
            result.warnings.add_lazily("points and lines, skipped", file, [&] {
                return std::pair(
                    std::string(),
                    fmt::format("found a face of {} corners, expected 3", face.mNumIndices));
            });
            continue;
        }
        for (const unsigned index : std::span(face.mIndices, 3)) {
            if (index >= mesh.mNumVertices)
                throw ParseError(file, "",
                                 fmt::format("found vertex index {} in a mesh of {} vertices",
                                             index, mesh.mNumVertices));
        }
        result.faces.push_back(
            Eigen::Map<const Eigen::Matrix<unsigned, 3, 1>>(face.mIndices).cast<int>());
    }
}

void read_attributes(const aiMesh& mesh, MeshAttributes& attributes) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        if (mesh.HasNormals()) {
            const aiVector3D& n = mesh.mNormals[i];
            attributes.normals.values.emplace_back(n.x, n.y, n.z);
        }
        if (mesh.HasTextureCoords(0)) {
            const aiVector3D& t = mesh.mTextureCoords[0][i];
            attributes.texture_coordinates.values.emplace_back(t.x, t.y);
        }
        if (mesh.HasVertexColors(0)) {
            const aiColor4D& c = mesh.mColors[0][i];
            attributes.colors.values.emplace_back(c.r, c.g, c.b, c.a);
        }
    }
}

}  // namespace

MeshData mesh_of(const aiMesh& mesh, const std::vector<std::string>& materials,
                 const std::string& file, const Limits& limits) {
    if (mesh.mNumVertices > limits.max_vertices || mesh.mNumFaces > limits.max_faces)
        throw ParseError(
            file, "",
            fmt::format("found {} vertices and {} faces, expected at most {} and {}",
                        mesh.mNumVertices, mesh.mNumFaces, limits.max_vertices, limits.max_faces));
    MeshData result;
    result.vertices.reserve(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& p = mesh.mVertices[i];
        result.vertices.emplace_back(p.x, p.y, p.z);
    }
    read_faces(mesh, file, result);
    read_attributes(mesh, result.attributes);
    if (mesh.mMaterialIndex < materials.size()) {
        result.attributes.materials.names = materials;
        result.attributes.materials.of_face.assign(result.faces.size(), mesh.mMaterialIndex);
    }
    return result;
}

}  // namespace boxwood
