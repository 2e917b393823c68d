// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "boxwood/core/files.h"
#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/write_lines.h"

namespace boxwood {

namespace {

using Buffer = fmt::memory_buffer;

void append_number(Buffer& buffer, double number) {
    fmt::format_to(std::back_inserter(buffer), " {}", number);
}

/// Colours that aren't from 0 to 1 would be read as others.
void append_color(Buffer& buffer, const VertexColor& color) {
    for (const float x : color) append_number(buffer, std::min(std::max(0.0F, x), 1.0F));
}

template <class Value>
const std::vector<Value>* values_of(const MeshValues<Value>& values, ValuesOf of) {
    return !values.is_empty() && values.of == of ? &values.values : nullptr;
}

}  // namespace

void write_off(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes) {
    check_indices(mesh);
    const auto* normals = values_of(attributes.normals, ValuesOf::vertices);
    const auto* colors = values_of(attributes.colors, ValuesOf::vertices);
    const auto* texture = values_of(attributes.texture_coordinates, ValuesOf::vertices);
    const auto* face_colors = values_of(attributes.colors, ValuesOf::faces);

    OutputFile file(path);
    file.write(fmt::format("{}{}{}OFF\n{} {} 0\n", texture ? "ST" : "", colors ? "C" : "",
                           normals ? "N" : "", mesh.vertices.size(), mesh.faces.size()));
    write_lines(file, mesh.vertices.size(), [&](Buffer& buffer, std::size_t i) {
        const Vec3d& v = mesh.vertices[i];
        fmt::format_to(std::back_inserter(buffer), "{} {} {}", v.x(), v.y(), v.z());
        if (normals)
            for (const float x : (*normals)[i]) append_number(buffer, x);
        if (colors) append_color(buffer, (*colors)[i]);
        if (texture)
            for (const float x : (*texture)[i]) append_number(buffer, x);
        buffer.push_back('\n');
    });
    write_lines(file, mesh.faces.size(), [&](Buffer& buffer, std::size_t i) {
        const Vec3i& f = mesh.faces[i];
        fmt::format_to(std::back_inserter(buffer), "3 {} {} {}", f.x(), f.y(), f.z());
        if (face_colors) append_color(buffer, (*face_colors)[i]);
        buffer.push_back('\n');
    });
    file.commit();
}

bool is_held_by_off(const AttributeName& attribute) {
    if (attribute.what == "colors") return attribute.of != ValuesOf::corners;
    return attribute.of == ValuesOf::vertices &&
           (attribute.what == "normals" || attribute.what == "texture coordinates");
}

}  // namespace boxwood
