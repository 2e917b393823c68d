// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/mesh_file.h"

#include <fmt/format.h>

#include <string>

#include "boxwood/core/error.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/gltf.h"
#include "boxwood/mesh/obj.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/ply.h"
#include "boxwood/mesh/stl.h"
#ifdef BOXWOOD_WITH_ASSIMP
#include "boxwood/mesh/assimp.h"
#endif

namespace boxwood {

namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

/// Formats that another library reads.
std::span<const MeshFormat> more_formats() {
#ifdef BOXWOOD_WITH_ASSIMP
    return assimp_formats();
#else
    return {};
#endif
}

InvalidInput unknown_format(const fs::path& path, bool must_write) {
    std::string known;
    for (const MeshFormat& format : mesh_formats()) {
        if (must_write && !format.write) continue;
        if (!known.empty()) known += ", ";
        known += format.extension;
    }
    const char* more = must_write               ? ""
                       : more_formats().empty() ? " (built with assimp, Boxwood would read more)"
                                                : " or in what assimp reads";
    const std::string extension = path.extension().string();
    return InvalidInput(
        fmt::format("{}: found {}, expected a mesh file that ends in {}{}", path.string(),
                    extension.empty() ? "a name without extension" : extension, known, more));
}

const MeshFormat* find_format(fs::path path) {
    if (lower_case_extension(path) == ".gz") path.replace_extension();
    const std::string extension = lower_case_extension(path);
    for (const std::span<const MeshFormat> formats : {mesh_formats(), more_formats()}) {
        for (const MeshFormat& format : formats) {
            if (format.extension == extension) return &format;
        }
    }
    return nullptr;
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
    static constexpr MeshFormat kFormats[] = {
        {".obj", "Wavefront OBJ", parse_obj, write_obj, is_held_by_obj},
        {".ply", "Polygon File Format", parse_ply, write_ply, is_held_by_ply},
        {".stl", "STL", parse_stl, write_stl, is_held_by_stl},
        {".off", "Object File Format", parse_off, write_off, is_held_by_off},
        {".gltf", "glTF 2.0", parse_gltf, write_gltf, is_held_by_gltf},
        {".glb", "glTF 2.0, binary", parse_gltf, write_glb, is_held_by_gltf},
    };
    return kFormats;
}

const MeshFormat& mesh_format_of(const fs::path& path) {
    if (const MeshFormat* format = find_format(path)) return *format;
    throw unknown_format(path, false);
}

MeshData read_mesh(const fs::path& path, const ReadOptions& options) {
    const MeshFormat& format = mesh_format_of(path);
    const FileContent content(path, options.limits);
    return format.parse({content.bytes(), path}, options);
}

void write_mesh(const fs::path& path, MeshView mesh, const MeshAttributes& attributes) {
    const MeshFormat* format = find_format(path);
    if (!format || !format->write || lower_case_extension(path) == ".gz")
        throw unknown_format(path, true);
    check_indices(mesh);
    check_attributes(mesh, attributes);
    format->write(path, mesh, attributes);
}

}  // namespace boxwood
