// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "boxwood/core/box.h"
#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/mesh/byte_order.h"
#include "boxwood/mesh/gltf.h"
#include "boxwood/mesh/gltf/base64.h"
#include "boxwood/mesh/split_corners.h"

namespace boxwood {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUint32 = 5125;
constexpr int kVertexData = 34962, kIndexData = 34963;

void append_number(std::string& bytes, std::uint32_t number) {
    bytes.resize(bytes.size() + 4);
    write_little_uint32(bytes.data() + bytes.size() - 4, number);
}
void append_number(std::string& bytes, float number) {
    bytes.resize(bytes.size() + 4);
    write_little_float(bytes.data() + bytes.size() - 4, number);
}

/// A mesh as glTF keeps it: one buffer, with the JSON that explains it.
class GltfParts {
public:
    explicit GltfParts(const MeshData& mesh) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Boxwood"}};
        json_["scene"] = 0;
        json_["scenes"] = {{{"nodes", {0}}}};
        json_["nodes"] = {{{"mesh", 0}}};
        add_attributes(mesh);
        add_primitives(mesh);
        if (!bytes_.empty()) json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    }

    Json& json() { return json_; }
    const std::string& bytes() const { return bytes_; }
    std::string text() const { return json_.dump(-1, ' ', false, Json::error_handler_t::replace); }

private:
    /// The accessor over what was appended since the given byte.
    Json& add_accessor(std::size_t begin, std::size_t count, const char* type, int component,
                       int target) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", begin},
                                        {"byteLength", bytes_.size() - begin},
                                        {"target", target}});
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", count},
                                      {"type", type}});
        return json_["accessors"].back();
    }
    std::size_t last_accessor() const { return json_["accessors"].size() - 1; }

    void add_attributes(const MeshData& mesh) {
        if (mesh.vertices.empty()) return;
        std::size_t begin = bytes_.size();
        Box3f box;
        for (const Vec3d& p : mesh.vertices) {
            const Vec3f rounded = p.cast<float>();
            for (const float x : rounded) append_number(bytes_, x);
            if (rounded.allFinite()) box.extend(rounded);
        }
        Json& positions = add_accessor(begin, mesh.vertices.size(), "VEC3", kFloat, kVertexData);
        if (box.is_empty()) box = {Vec3f::Zero(), Vec3f::Zero()};
        positions["min"] = {box.lo.x(), box.lo.y(), box.lo.z()};
        positions["max"] = {box.hi.x(), box.hi.y(), box.hi.z()};
        attributes_["POSITION"] = last_accessor();

        const MeshAttributes& all = mesh.attributes;
        begin = bytes_.size();
        if (!all.normals.is_empty()) {
            for (const Vec3f& n : all.normals.values)
                for (const float x : n) append_number(bytes_, x);
            add_accessor(begin, all.normals.values.size(), "VEC3", kFloat, kVertexData);
            attributes_["NORMAL"] = last_accessor();
        }
        begin = bytes_.size();
        if (!all.texture_coordinates.is_empty()) {
            for (const Vec2f& uv : all.texture_coordinates.values) {
                append_number(bytes_, uv.x());
                append_number(bytes_, 1 - uv.y());
            }
            add_accessor(begin, all.texture_coordinates.values.size(), "VEC2", kFloat, kVertexData);
            attributes_["TEXCOORD_0"] = last_accessor();
        }
        begin = bytes_.size();
        if (!all.colors.is_empty()) {
            for (const VertexColor& color : all.colors.values)
                for (const float x : color) append_number(bytes_, x);
            add_accessor(begin, all.colors.values.size(), "VEC4", kFloat, kVertexData);
            attributes_["COLOR_0"] = last_accessor();
        }
    }

    void add_primitives(const MeshData& mesh) {
        const FaceLabels& labels = mesh.attributes.materials;
        for (const std::string& name : labels.names) json_["materials"].push_back({{"name", name}});
        Json primitives = Json::array();
        for (std::size_t first = 0, last = 0; first < mesh.faces.size(); first = last) {
            while (last < mesh.faces.size() &&
                   (labels.is_empty() || labels.of_face[last] == labels.of_face[first]))
                ++last;
            const std::size_t begin = bytes_.size();
            for (std::size_t i = first; i < last; ++i)
                for (const int corner : mesh.faces[i])
                    append_number(bytes_, static_cast<std::uint32_t>(corner));
            add_accessor(begin, 3 * (last - first), "SCALAR", kUint32, kIndexData);
            Json primitive = {{"attributes", attributes_}, {"indices", last_accessor()}};
            if (!labels.is_empty()) primitive["material"] = labels.of_face[first];
            primitives.push_back(std::move(primitive));
        }
        // The format wants a primitive and vertices; what is empty becomes an empty scene.
        if (primitives.empty()) {
            json_.erase("nodes");
            json_["scenes"] = Json::array({Json::object()});
        } else {
            json_["meshes"] = {{{"primitives", std::move(primitives)}}};
        }
    }

    Json json_;
    Json attributes_ = Json::object();
    std::string bytes_;
};

void append_chunk(std::string& file, const char* type, std::string bytes, char filler) {
    while (bytes.size() % 4 != 0) bytes += filler;
    append_number(file, static_cast<std::uint32_t>(bytes.size()));
    file.append(type, 4);
    file += bytes;
}

}  // namespace

void write_glb(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes) {
    const GltfParts parts(split_corners(mesh, attributes));
    std::string chunks;
    if (parts.bytes().size() > std::numeric_limits<std::uint32_t>::max() - (1u << 24))
        throw InvalidInput(
            fmt::format("{}: {} bytes are more than a .glb can hold, expected at "
                        "most 4 GiB",
                        path.string(), parts.bytes().size()));
    append_chunk(chunks, "JSON", parts.text(), ' ');
    if (!parts.bytes().empty()) append_chunk(chunks, "BIN\0", parts.bytes(), '\0');
    std::string header = "glTF";
    append_number(header, std::uint32_t{2});
    append_number(header, static_cast<std::uint32_t>(12 + chunks.size()));
    OutputFile file(path);
    file.write(header);
    file.write(chunks);
    file.commit();
}

void write_gltf(const std::filesystem::path& path, MeshView mesh,
                const MeshAttributes& attributes) {
    GltfParts parts(split_corners(mesh, attributes));
    if (!parts.bytes().empty())
        parts.json()["buffers"][0]["uri"] =
            "data:application/octet-stream;base64," + base64_encoded(parts.bytes());
    OutputFile file(path);
    file.write(parts.text());
    file.commit();
}

bool is_held_by_gltf(const AttributeName& attribute) {
    return attribute.what == "normals" || attribute.what == "texture coordinates" ||
           attribute.what == "colors" || attribute.what == "materials";
}

}  // namespace boxwood
