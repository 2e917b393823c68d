// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/json_reader.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// A glTF 2.0 file, .gltf or .glb: its JSON, and its buffers wherever they lie. Every length and
/// offset that it names is checked before it is followed.
/// Source: Khronos Group, "glTF 2.0 Specification", 2.0.1, 2021.
class GltfDocument {
public:
    /// The source's bytes must outlive it. Throws IoError when a buffer's file can't be read, and
    /// ParseError; also for an extension that the file requires and Boxwood doesn't have.
    GltfDocument(const MeshSource& source, const ReadOptions& options);

    const JsonReader& json() const { return json_; }
    const Limits& limits() const { return options_.limits; }
    std::string name() const { return path_.string(); }

    /// Item i of a top-level array such as "meshes".
    JsonReader item(const std::string& array, std::size_t i) const;
    /// How many there are; 0 without the array.
    std::size_t count(const std::string& array) const;
    /// The item of a top-level array that a value names by its index.
    std::size_t index(const JsonReader& value, const std::string& array) const {
        return value.index(count(array));
    }

    struct View {
        std::string_view bytes;
        std::size_t stride = 0;  ///< 0 where the file gives none
    };
    /// The bytes of buffer view i.
    View view(std::size_t i) const;

    /// The bytes of a "uri": in the URI itself, or in a file beside this one.
    std::string resolve(const JsonReader& uri) const;

private:
    struct Buffer {
        std::string owned;  ///< unless it lies in the .glb
        std::string_view bytes;
    };

    void check_version() const;
    void check_extensions() const;
    void load_buffers();

    std::filesystem::path path_;
    ReadOptions options_;
    std::optional<std::string_view> binary_;  ///< the chunk of a .glb that buffer 0 may lie in
    JsonReader json_;
    std::map<std::string, std::vector<JsonReader>> arrays_;
    std::vector<Buffer> buffers_;
};

}  // namespace boxwood
