// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "boxwood/core/files.h"
#include "boxwood/mesh/ply.h"
#include "boxwood/mesh/ply/ply_columns.h"
#include "boxwood/mesh/ply/ply_header.h"
#include "boxwood/mesh/write_lines.h"

namespace boxwood {

namespace {

using Buffer = fmt::memory_buffer;

template <class Number>
void append(Buffer& buffer, Number number) {
    const char* bytes = reinterpret_cast<const char*>(&number);
    if constexpr (std::endian::native == std::endian::little) {
        buffer.append(bytes, bytes + sizeof(Number));
    } else {
        for (std::size_t i = sizeof(Number); i > 0; --i) buffer.push_back(bytes[i - 1]);
    }
}

bool is_float(double x) {
    if (!std::isfinite(x)) return true;
    return std::abs(x) <= std::numeric_limits<float>::max() && static_cast<float>(x) == x;
}

/// The byte that a part of a colour is read from, or -1.
int byte_of(float part) {
    if (!(part >= 0 && part <= 1)) return -1;
    const auto byte = static_cast<int>(std::lround(part * 255));
    return ply_color(byte, 255) == part ? byte : -1;
}

/// An element with how each of its items is written.
struct Writer {
    PlyElement element;
    std::vector<std::function<void(Buffer&, std::size_t)>> parts;

    void add_numbers(PlyType type, const std::vector<const char*>& names) {
        for (const char* name : names) element.properties.push_back({name, type, false, {}, 0});
    }

    template <class Values>
    void add_floats(const Values& values, const std::vector<const char*>& names) {
        add_numbers(PlyType::float32, names);
        parts.push_back([&values](Buffer& buffer, std::size_t i) {
            for (const float x : values[i]) append(buffer, x);
        });
    }

    void add_colors(const std::vector<VertexColor>& colors) {
        const bool has_alpha = std::any_of(colors.begin(), colors.end(),
                                           [](const VertexColor& c) { return c.w() != 1; });
        const bool has_bytes = std::all_of(colors.begin(), colors.end(), [](const VertexColor& c) {
            return std::all_of(c.begin(), c.end(), [](float part) { return byte_of(part) >= 0; });
        });
        const PlyType type = has_bytes ? PlyType::uint8 : PlyType::float32;
        add_numbers(type, {"red", "green", "blue"});
        if (has_alpha) add_numbers(type, {"alpha"});
        parts.push_back([&colors, has_alpha, has_bytes](Buffer& buffer, std::size_t i) {
            for (int k = 0; k < (has_alpha ? 4 : 3); ++k) {
                if (has_bytes) {
                    append(buffer, static_cast<std::uint8_t>(byte_of(colors[i][k])));
                } else {
                    append(buffer, colors[i][k]);
                }
            }
        });
    }

    void add_field(const MeshField& field, const std::vector<PlyRole>& taken_roles) {
        const bool has_floats = std::all_of(field.values.begin(), field.values.end(), is_float);
        element.properties.push_back({free_name(field.name, taken_roles),
                                      has_floats ? PlyType::float32 : PlyType::float64,
                                      false,
                                      {},
                                      0});
        parts.push_back([&field, has_floats](Buffer& buffer, std::size_t i) {
            if (has_floats) {
                append(buffer, static_cast<float>(field.values[i]));
            } else {
                append(buffer, field.values[i]);
            }
        });
    }

    /// The name without what would part words, and changed until it's no other's and means nothing.
    std::string free_name(std::string name, const std::vector<PlyRole>& taken_roles) const {
        for (char& c : name) {
            if (!(c > ' ' && c <= '~')) c = '_';
        }
        if (name.empty()) name = "_";
        for (;; name += '_') {
            PlyElement with_field = element;
            const bool is_taken =
                std::any_of(element.properties.begin(), element.properties.end(),
                            [&](const PlyProperty& other) { return other.name == name; });
            with_field.properties.push_back({name, PlyType::float32, false, {}, 0});
            if (!is_taken && ply_columns(with_field, taken_roles).back().role == PlyRole::field)
                return name;
        }
    }

    std::string header() const {
        std::string text = fmt::format("element {} {}\n", element.name, element.count);
        for (const PlyProperty& property : element.properties) {
            const char* type = property.type == PlyType::uint8     ? "uchar"
                               : property.type == PlyType::int32   ? "int"
                               : property.type == PlyType::float32 ? "float"
                                                                   : "double";
            text += fmt::format("property {}{} {}\n", property.is_list ? "list uchar " : "", type,
                                property.name);
        }
        return text;
    }

    void write(OutputFile& file) const {
        write_lines(file, element.count, [this](Buffer& buffer, std::size_t i) {
            for (const auto& part : parts) part(buffer, i);
        });
    }
};

void add_positions(Writer& writer, MeshView mesh) {
    const bool has_floats =
        std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                    [](const Vec3d& v) { return std::all_of(v.begin(), v.end(), is_float); });
    writer.add_numbers(has_floats ? PlyType::float32 : PlyType::float64, {"x", "y", "z"});
    writer.parts.push_back([mesh, has_floats](Buffer& buffer, std::size_t i) {
        for (const double x : mesh.vertices[i]) {
            if (has_floats) {
                append(buffer, static_cast<float>(x));
            } else {
                append(buffer, x);
            }
        }
    });
}

void add_corners(Writer& writer, MeshView mesh) {
    writer.element.properties.push_back(
        {"vertex_indices", PlyType::int32, true, PlyType::uint8, 0});
    writer.parts.push_back([mesh](Buffer& buffer, std::size_t i) {
        append(buffer, std::uint8_t{3});
        for (const int index : mesh.faces[i]) append(buffer, std::int32_t{index});
    });
}

void add_corner_texture(Writer& writer, const std::vector<Vec2f>& values) {
    writer.element.properties.push_back({"texcoord", PlyType::float32, true, PlyType::uint8, 0});
    writer.parts.push_back([&values](Buffer& buffer, std::size_t i) {
        append(buffer, std::uint8_t{6});
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
            for (const float x : values[k]) append(buffer, x);
        }
    });
}

void add_attributes(Writer& writer, ValuesOf of, const MeshAttributes& attributes) {
    const auto has = [&](const auto& values) { return !values.is_empty() && values.of == of; };
    if (has(attributes.normals)) writer.add_floats(attributes.normals.values, {"nx", "ny", "nz"});
    if (of == ValuesOf::vertices && has(attributes.texture_coordinates))
        writer.add_floats(attributes.texture_coordinates.values, {"s", "t"});
    if (has(attributes.colors)) writer.add_colors(attributes.colors.values);

    // As the reader takes them, so that no field is mistaken.
    std::vector<PlyRole> taken;
    const auto take = [&](PlyRole role, const auto& values, ValuesOf owner) {
        if (!values.is_empty() && values.of == owner) taken.push_back(role);
    };
    if (of == ValuesOf::vertices) {
        take(PlyRole::texture_coordinate, attributes.texture_coordinates, ValuesOf::corners);
    } else {
        taken = {PlyRole::position, PlyRole::texture_coordinate};
        take(PlyRole::normal, attributes.normals, ValuesOf::vertices);
        take(PlyRole::color, attributes.colors, ValuesOf::vertices);
    }
    for (const MeshField& field : attributes.fields) {
        if (field.of == of) writer.add_field(field, taken);
    }
}

}  // namespace

void write_ply(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes) {
    check_indices(mesh);
    Writer vertices, faces;
    vertices.element = {"vertex", mesh.vertices.size(), 0, {}};
    add_positions(vertices, mesh);
    add_attributes(vertices, ValuesOf::vertices, attributes);
    faces.element = {"face", mesh.faces.size(), 0, {}};
    add_corners(faces, mesh);
    const MeshValues<Vec2f>& texture = attributes.texture_coordinates;
    if (!texture.is_empty() && texture.of == ValuesOf::corners)
        add_corner_texture(faces, texture.values);
    add_attributes(faces, ValuesOf::faces, attributes);

    OutputFile file(path);
    file.write("ply\nformat binary_little_endian 1.0\n" + vertices.header() + faces.header() +
               "end_header\n");
    vertices.write(file);
    faces.write(file);
    file.commit();
}

bool is_held_by_ply(const AttributeName& attribute) {
    if (attribute.what == "normals") return attribute.of == ValuesOf::vertices;
    if (attribute.what == "texture coordinates") return attribute.of != ValuesOf::faces;
    return attribute.of != ValuesOf::corners &&
           (attribute.what == "colors" || attribute.what.starts_with("field "));
}

}  // namespace boxwood
