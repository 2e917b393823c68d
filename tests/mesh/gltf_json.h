// SPDX-License-Identifier: Apache-2.0
// Small glTF files as JSON, for tests that read and spoil them.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "boxwood/mesh/gltf.h"
#include "boxwood/mesh/gltf/base64.h"

namespace boxwood {

using Json = nlohmann::json;

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers) {
        char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        bytes.append(raw, sizeof number);
    }
    return bytes;
}

inline std::string data_uri(std::string_view bytes) {
    return "data:application/octet-stream;base64," + base64_encoded(bytes);
}

/// A square of two triangles at z = 0: four positions, indices in 16 bits, normals, texture
/// coordinates and colors, with a node, a camera, a light, a material and a texture of one pixel.
inline Json square_gltf() {
    const std::string positions = bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const std::string indices = bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
    const std::string normals = bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const std::string uv = bytes_of<float>({0, 1, 1, 1, 1, 0, 0, 0});
    const std::string colors =
        bytes_of<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 51});
    Json json = Json::parse(R"({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "children": [1, 2]},
                  {"camera": 0, "translation": [0.5, 0.5, 2]},
                  {"translation": [0, 0, 3], "name": "lamp",
                   "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "aspectRatio": 1.5}}],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 0.5, 0.25], "intensity": 10}]}},
        "materials": [{"name": "paint", "doubleSided": true,
                       "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1],
                                                "metallicFactor": 0, "roughnessFactor": 0.5}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 2, "TEXCOORD_0": 3,
                                                   "COLOR_0": 4},
                                    "indices": 1, "material": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 4, "componentType": 5121, "count": 4, "type": "VEC4",
             "normalized": true}],
        "bufferViews": [], "buffers": []})");
    std::string bytes;
    for (const std::string& part : {positions, indices, normals, uv, colors}) {
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", part.size()}});
        bytes += part;
    }
    json["buffers"] = {{{"byteLength", bytes.size()}, {"uri", data_uri(bytes)}}};
    return json;
}

inline MeshData parsed(const Json& json, const ReadOptions& options = {}) {
    const std::string text = json.dump();
    return parse_gltf({text, "mesh.gltf"}, options);
}

/// A .glb of these chunks, with the lengths that it should have.
inline std::string glb_of(std::string json, std::string binary) {
    while (json.size() % 4 != 0) json += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    const auto number = [](std::size_t n) {
        return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(n)});
    };
    std::string chunks = number(json.size()) + "JSON" + json;
    if (!binary.empty()) chunks += number(binary.size()) + std::string("BIN\0", 4) + binary;
    return "glTF" + number(2) + number(12 + chunks.size()) + chunks;
}

}  // namespace boxwood
