// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "boxwood/core/files.h"
#include "boxwood/mesh/obj.h"
#include "boxwood/mesh/write_lines.h"

namespace boxwood {

namespace {

/// The name as a line can hold it.
std::string safe_name(std::string name) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    for (std::size_t i = 0; i < name.size(); ++i) {
        char& c = name[i];
        const bool is_at_end = i == 0 || i + 1 == name.size();
        const bool is_control = static_cast<unsigned char>(c) < ' ' && c != '\t';
        const bool starts_comment = c == '#' && (i == 0 || is_blank(name[i - 1]));
        const bool joins_lines = c == '\\' && i + 1 == name.size();
        if (is_control || starts_comment || joins_lines || (is_blank(c) && is_at_end)) c = '_';
    }
    return name;
}

class ObjWriter {
public:
    ObjWriter(OutputFile& file, MeshView mesh, const MeshAttributes& attributes)
        : file_(file), mesh_(mesh), attributes_(attributes) {}

    void write() {
        file_.write(
            fmt::format("# {} vertices, {} faces\n", mesh_.vertices.size(), mesh_.faces.size()));
        for (const std::string& file : attributes_.material_files)
            file_.write("mtllib " + safe_name(file) + "\n");
        write_vertices();
        write_values("vt", attributes_.texture_coordinates);
        write_values("vn", attributes_.normals);
        write_lines(file_, mesh_.faces.size(),
                    [this](fmt::memory_buffer& buffer, std::size_t i) { append_face(buffer, i); });
    }

private:
    void write_vertices() {
        const MeshValues<VertexColor>& colors = attributes_.colors;
        const bool has_colors = !colors.is_empty() && colors.of == ValuesOf::vertices;
        const bool has_alpha =
            has_colors && std::any_of(colors.values.begin(), colors.values.end(),
                                      [](const VertexColor& color) { return color.w() != 1; });
        write_lines(file_, mesh_.vertices.size(), [&](fmt::memory_buffer& buffer, std::size_t i) {
            const Vec3d& v = mesh_.vertices[i];
            const auto out = std::back_inserter(buffer);
            fmt::format_to(out, "v {} {} {}", v.x(), v.y(), v.z());
            if (has_colors) {
                const VertexColor& color = colors.values[i];
                fmt::format_to(out, " {} {} {}", color.x(), color.y(), color.z());
                if (has_alpha) fmt::format_to(out, " {}", color.w());
            }
            buffer.push_back('\n');
        });
    }

    template <class Value>
    void write_values(std::string_view keyword, const MeshValues<Value>& values) {
        write_lines(file_, values.values.size(), [&](fmt::memory_buffer& buffer, std::size_t i) {
            buffer.append(keyword);
            for (const float x : values.values[i])
                fmt::format_to(std::back_inserter(buffer), " {}", x);
            buffer.push_back('\n');
        });
        // One more that nobody uses tells values of corners from values of vertices, where their
        // indices would be the same.
        if (values.is_empty() || values.of == ValuesOf::vertices) return;
        if (values.values.size() != mesh_.vertices.size()) return;
        file_.write(keyword);
        for (int k = 0; k < Value::SizeAtCompileTime; ++k) file_.write(" 0");
        file_.write("\n");
    }

    void append_face(fmt::memory_buffer& buffer, std::size_t face) const {
        append_label(buffer, "g", attributes_.groups, face);
        append_label(buffer, "usemtl", attributes_.materials, face);
        const auto out = std::back_inserter(buffer);
        buffer.push_back('f');
        for (std::size_t k = 0; k < 3; ++k) {
            const int vertex = mesh_.faces[face][static_cast<int>(k)];
            fmt::format_to(out, " {}", vertex + std::int64_t{1});
            const bool has_normal = !attributes_.normals.is_empty();
            if (!attributes_.texture_coordinates.is_empty()) {
                fmt::format_to(out, "/{}",
                               index(attributes_.texture_coordinates.of, vertex, face, k));
            } else if (has_normal) {
                buffer.push_back('/');
            }
            if (has_normal)
                fmt::format_to(out, "/{}", index(attributes_.normals.of, vertex, face, k));
        }
        buffer.push_back('\n');
    }

    /// Where it differs from that of the face before.
    static void append_label(fmt::memory_buffer& buffer, std::string_view keyword,
                             const FaceLabels& labels, std::size_t face) {
        if (labels.is_empty()) return;
        const std::uint32_t label = labels.of_face[face];
        if (face > 0 && labels.of_face[face - 1] == label) return;
        fmt::format_to(std::back_inserter(buffer), "{} {}\n", keyword,
                       safe_name(labels.names[label]));
    }

    static std::size_t index(ValuesOf of, int vertex, std::size_t face, std::size_t k) {
        if (of == ValuesOf::vertices) return static_cast<std::size_t>(vertex) + 1;
        return of == ValuesOf::faces ? face + 1 : 3 * face + k + 1;
    }

    OutputFile& file_;
    MeshView mesh_;
    const MeshAttributes& attributes_;
};

}  // namespace

void write_obj(const std::filesystem::path& path, MeshView mesh, const MeshAttributes& attributes) {
    check_indices(mesh);
    OutputFile file(path);
    ObjWriter(file, mesh, attributes).write();
    file.commit();
}

bool is_held_by_obj(const AttributeName& attribute) {
    if (attribute.what == "colors") return attribute.of == ValuesOf::vertices;
    return !attribute.what.starts_with("field ");
}

}  // namespace boxwood
