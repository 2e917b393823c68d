// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/gltf/document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/gltf/base64.h"
#include "boxwood/mesh/gltf/glb.h"
#include "boxwood/mesh/side_file.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// Those that change what a file means, and that are read.
constexpr std::array<std::string_view, 5> kExtensions = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform"};

}  // namespace

GltfDocument::GltfDocument(const MeshSource& source, const ReadOptions& options)
    : path_(source.path),
      options_(options),
      binary_(glb_binary(source)),
      json_(JsonReader::parse(glb_json(source), source.name(), options.limits)) {
    check_version();
    check_extensions();
    for (const char* name : {"accessors", "buffers", "bufferViews", "cameras", "images",
                             "materials", "meshes", "nodes", "samplers", "scenes", "textures"}) {
        if (const auto array = json_.find(name)) arrays_[name] = array->array();
    }
    load_buffers();
}

void GltfDocument::check_version() const {
    const JsonReader asset = json_["asset"];
    const JsonReader version = asset["version"];
    const std::string text = version.string();
    const auto least = asset.find("minVersion");
    if (!text.starts_with("2.") || (least && least->string() != "2.0"))
        (least ? *least : version).fail("glTF version 2.0");
}

void GltfDocument::check_extensions() const {
    const auto required = json_.find("extensionsRequired");
    if (!required) return;
    for (const JsonReader& item : required->array()) {
        const std::string name = item.string();
        if (std::find(kExtensions.begin(), kExtensions.end(), name) == kExtensions.end())
            item.fail(fmt::format("one of the extensions {}", fmt::join(kExtensions, ", ")));
    }
}

void GltfDocument::load_buffers() {
    const std::vector<JsonReader>& items = arrays_["buffers"];
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        Buffer& buffer = buffers_.emplace_back();
        const std::uint64_t length =
            items[i]["byteLength"].integer(0, options_.limits.max_bytes - total);
        total += length;
        if (const auto uri = items[i].find("uri")) {
            buffer.owned = resolve(*uri);
            buffer.bytes = buffer.owned;
        } else if (i == 0 && binary_) {
            buffer.bytes = *binary_;
        } else {
            items[i].fail("a buffer with a uri, or the first one of a .glb with a binary chunk");
        }
        if (buffer.bytes.size() < length)
            items[i]["byteLength"].fail(
                fmt::format("at most {}, the size of its data", buffer.bytes.size()));
        buffer.bytes = buffer.bytes.substr(0, length);
    }
    // Strings may have moved, and short ones take their bytes with them.
    for (Buffer& buffer : buffers_) {
        if (!buffer.owned.empty())
            buffer.bytes = std::string_view(buffer.owned).substr(0, buffer.bytes.size());
    }
}

std::string GltfDocument::resolve(const JsonReader& value) const {
    const std::string uri = value.string();
    if (uri.starts_with("data:")) {
        constexpr std::string_view kMarker = ";base64,";
        const std::size_t marker = uri.find(kMarker);
        auto bytes = marker == uri.npos
                         ? std::nullopt
                         : base64_decoded(std::string_view(uri).substr(marker + kMarker.size()));
        if (!bytes) value.fail("a data URI with base64");
        return *std::move(bytes);
    }
    const std::string name = percent_decoded(uri);
    const fs::path folder = path_.parent_path();
    if (const auto refusal = refusal_of(folder, name, options_.allow_outside_files))
        value.fail(*refusal);
    return std::string(FileContent(folder / name, options_.limits).bytes());
}

JsonReader GltfDocument::item(const std::string& array, std::size_t i) const {
    return arrays_.at(array).at(i);
}

std::size_t GltfDocument::count(const std::string& array) const {
    const auto found = arrays_.find(array);
    return found == arrays_.end() ? 0 : found->second.size();
}

GltfDocument::View GltfDocument::view(std::size_t i) const {
    const JsonReader value = item("bufferViews", i);
    const std::string_view buffer = buffers_[index(value["buffer"], "buffers")].bytes;
    const auto offset_value = value.find("byteOffset");
    const std::uint64_t offset = offset_value ? offset_value->integer(0, buffer.size()) : 0;
    const std::uint64_t length = value["byteLength"].integer(0, buffer.size() - offset);
    const auto stride = value.find("byteStride");
    return {buffer.substr(offset, length), stride ? stride->integer(1, 255) : 0};
}

}  // namespace boxwood
