// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "boxwood/mesh/gltf.h"
#include "boxwood/mesh/gltf/document.h"
#include "boxwood/mesh/gltf/gltf_mesh.h"
#include "boxwood/mesh/gltf/gltf_nodes.h"
#include "boxwood/mesh/placement.h"

namespace boxwood {

namespace {

/// Normals go by the inverse transpose; cofactors are that, times the determinant.
MeshValues<Vec3f> moved(MeshValues<Vec3f> normals, const AffineMap& to_world) {
    const Eigen::Matrix3d m = to_world.linear();
    Eigen::Matrix3d cofactors;
    cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
    if (m.determinant() < 0) cofactors = -cofactors;
    for (Vec3f& n : normals.values) n = (cofactors * n.cast<double>()).normalized().cast<float>();
    return normals;
}

/// Puts meshes, where they stand, one behind another.
class Assembly {
public:
    explicit Assembly(const GltfDocument& document) : document_(document) {}

    void add(const JsonReader& place, const MeshData& part, const AffineMap& to_world,
             const std::string& name) {
        const Limits& limits = document_.limits();
        if (part.vertices.size() > limits.max_vertices - mesh_.vertices.size() ||
            part.faces.size() > limits.max_faces - mesh_.faces.size())
            place.fail(fmt::format("at most {} vertices and {} faces in all", limits.max_vertices,
                                   limits.max_faces));
        const Vec3i shift = Vec3i::Constant(static_cast<int>(mesh_.vertices.size()));
        const bool is_moved = to_world.matrix() != AffineMap::Identity().matrix();
        for (const Vec3d& p : part.vertices)
            mesh_.vertices.push_back(is_moved ? Vec3d(to_world * p) : p);
        // A mirrored mesh keeps its fronts outside.
        const bool is_mirrored = to_world.linear().determinant() < 0;
        for (const Vec3i& f : part.faces)
            mesh_.faces.emplace_back((is_mirrored ? Vec3i(f[0], f[2], f[1]) : f) + shift);
        add_attributes(part.attributes, to_world, is_moved);
        FaceLabels& groups = mesh_.attributes.groups;
        groups.names.push_back(name);
        groups.of_face.resize(mesh_.faces.size(),
                              static_cast<std::uint32_t>(groups.names.size() - 1));
    }

    MeshData finish(const std::map<std::size_t, MeshData>& parts) {
        for (const auto& [i, part] : parts) mesh_.warnings.append(part.warnings);
        MeshAttributes& all = mesh_.attributes;
        const std::size_t count = mesh_.vertices.size();
        fill_up(all.normals, count, Vec3f(0, 0, 0));
        fill_up(all.texture_coordinates, count, Vec2f(0, 0));
        fill_up(all.colors, count, VertexColor(VertexColor::Ones()));
        if (all.groups.names.size() < 2) all.groups = {};
        if (all.materials.names.size() < 2) all.materials = {};
        return std::move(mesh_);
    }

private:
    void add_attributes(const MeshAttributes& part, const AffineMap& to_world, bool is_moved) {
        MeshAttributes& all = mesh_.attributes;
        append(all.normals, is_moved ? moved(part.normals, to_world) : part.normals,
               Vec3f(0, 0, 0));
        append(all.texture_coordinates, part.texture_coordinates, Vec2f(0, 0));
        append(all.colors, part.colors, VertexColor(VertexColor::Ones()));
        all.materials.names = part.materials.names;
        all.materials.of_face.insert(all.materials.of_face.end(), part.materials.of_face.begin(),
                                     part.materials.of_face.end());
        vertices_ = mesh_.vertices.size();
    }

    /// Vertices before that have no such values get the one for none.
    template <class Value>
    void append(MeshValues<Value>& all, const MeshValues<Value>& part, const Value& none) {
        if (part.is_empty()) return;
        all.values.resize(vertices_, none);
        all.values.insert(all.values.end(), part.values.begin(), part.values.end());
    }
    template <class Value>
    static void fill_up(MeshValues<Value>& all, std::size_t count, const Value& none) {
        if (!all.is_empty()) all.values.resize(count, none);
    }

    const GltfDocument& document_;
    MeshData mesh_;
    std::size_t vertices_ = 0;  ///< before the part at hand
};

std::string name_of(const JsonReader& value, const char* kind, std::size_t i) {
    const auto name = value.find("name");
    return name ? name->string() : fmt::format("{} {}", kind, i);
}

}  // namespace

MeshData parse_gltf(const MeshSource& source, const ReadOptions& options) {
    const GltfDocument document(source, options);
    Assembly assembly(document);
    std::map<std::size_t, MeshData> parts;
    const auto part = [&](std::size_t i) -> const MeshData& {
        const auto found = parts.find(i);
        return found != parts.end() ? found->second
                                    : parts.emplace(i, read_gltf_mesh(document, i)).first->second;
    };
    if (document.count("nodes") == 0) {
        for (std::size_t i = 0; i < document.count("meshes"); ++i) {
            const JsonReader mesh = document.item("meshes", i);
            assembly.add(mesh, part(i), AffineMap::Identity(), name_of(mesh, "mesh", i));
        }
    }
    std::size_t nodes = 0;
    for_each_gltf_node(document, [&](const JsonReader& node, const AffineMap& to_world) {
        ++nodes;
        if (const auto mesh = node.find("mesh"))
            assembly.add(node, part(document.index(*mesh, "meshes")), to_world,
                         name_of(node, "node", nodes - 1));
    });
    return assembly.finish(parts);
}

}  // namespace boxwood
