// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <string>

#include "boxwood/mesh/gltf.h"
#include "boxwood/mesh/gltf/document.h"
#include "boxwood/mesh/gltf/gltf_mesh.h"
#include "boxwood/mesh/gltf/gltf_nodes.h"
#include "boxwood/mesh/mesh_assembly.h"

namespace boxwood {

namespace {

std::string name_of(const JsonReader& value, const char* kind, std::size_t i) {
    const auto name = value.find("name");
    return name ? name->string() : fmt::format("{} {}", kind, i);
}

}  // namespace

MeshData parse_gltf(const MeshSource& source, const ReadOptions& options) {
    const GltfDocument document(source, options);
    MeshAssembly assembly;
    std::map<std::size_t, MeshData> parts;
    const auto part = [&](std::size_t i) -> const MeshData& {
        const auto found = parts.find(i);
        return found != parts.end() ? found->second
                                    : parts.emplace(i, read_gltf_mesh(document, i)).first->second;
    };
    const auto add = [&](const JsonReader& place, std::size_t i, const AffineMap& to_world,
                         const std::string& name) {
        const Limits& limits = document.limits();
        if (!assembly.has_room_for(part(i), limits))
            place.fail(fmt::format("at most {} vertices and {} faces in all", limits.max_vertices,
                                   limits.max_faces));
        assembly.add(part(i), to_world, name);
    };
    if (document.count("nodes") == 0) {
        for (std::size_t i = 0; i < document.count("meshes"); ++i) {
            const JsonReader mesh = document.item("meshes", i);
            add(mesh, i, AffineMap::Identity(), name_of(mesh, "mesh", i));
        }
    }
    std::size_t nodes = 0;
    for_each_gltf_node(document, [&](const JsonReader& node, const AffineMap& to_world) {
        ++nodes;
        if (const auto mesh = node.find("mesh"))
            add(node, document.index(*mesh, "meshes"), to_world, name_of(node, "node", nodes - 1));
    });
    MeshData mesh = assembly.finish();
    for (const auto& [i, of_part] : parts) mesh.warnings.append(of_part.warnings);
    return mesh;
}

}  // namespace boxwood
