// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/ply.h"
#include "boxwood/mesh/ply/ply_body.h"
#include "boxwood/mesh/text_chunks.h"
#include "boxwood/mesh/text_scanner.h"
#include "boxwood/mesh/triangulate.h"
#include "boxwood/mesh/warn_of_vertices.h"

namespace boxwood {

namespace {

class PlyReader {
public:
    PlyReader(const MeshSource& source, const Limits& limits) {
        constexpr std::uint64_t kMostIndices = std::numeric_limits<int>::max();
        body_.name = source.name();
        body_.text = source.bytes;
        body_.max_faces =
            static_cast<std::size_t>(std::min<std::uint64_t>(limits.max_faces, kMostIndices));
        body_.header = read_ply_header(source, limits);
    }

    MeshData read() {
        find_elements();
        find_properties();
        warn_of_skipped();
        parts_ =
            body_.header.format == PlyFormat::ascii ? read_ply_text(body_) : read_ply_binary(body_);
        if (body_.has_unfinite_vertices) warn_of_vertices(body_.name, mesh_);
        join();
        return std::move(mesh_);
    }

private:
    const PlyElement* find_element(std::string_view name) const {
        for (const PlyElement& element : body_.header.elements) {
            if (element.name == name) return &element;
        }
        return nullptr;
    }

    void find_elements() {
        const auto find_some = [this](std::string_view name) {
            const PlyElement* element = find_element(name);
            return element && element->count > 0 ? element : nullptr;
        };
        body_.vertices = find_element("vertex");
        body_.faces = find_some("face");
        body_.strips = find_some("tristrips");
        if (!body_.vertices)
            throw ParseError(body_.name, body_.header.lines,
                             "the header has no element vertex, expected one");
    }

    static std::optional<std::size_t> find_list(const PlyElement& element, std::string_view name) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (element.properties[i].is_list && element.properties[i].name == name) return i;
        }
        return std::nullopt;
    }

    std::size_t find_indices(const PlyElement& element) const {
        for (const char* name : {"vertex_indices", "vertex_index"}) {
            if (const auto found = find_list(element, name)) return *found;
        }
        throw ParseError(body_.name, element.line,
                         fmt::format("the element {} has no list of vertex_indices, expected one",
                                     element.name));
    }

    void find_properties() {
        // Texture coordinates of corners are worth more than those of vertices.
        if (body_.faces) body_.face_texture_coordinates = find_list(*body_.faces, "texcoord");
        std::vector<PlyRole> taken;
        if (body_.face_texture_coordinates) taken.push_back(PlyRole::texture_coordinate);
        body_.vertex_columns = ply_columns(*body_.vertices, taken);
        if (!has_role(body_.vertex_columns, PlyRole::position))
            throw ParseError(body_.name, body_.vertices->line,
                             "the element vertex lacks x, y or z, expected them");
        if (body_.faces) {
            body_.face_indices = find_indices(*body_.faces);
            // So are normals and colours of vertices.
            taken = {PlyRole::position, PlyRole::texture_coordinate};
            for (const PlyRole role : {PlyRole::normal, PlyRole::color}) {
                if (has_role(body_.vertex_columns, role)) taken.push_back(role);
            }
            body_.face_columns = ply_columns(*body_.faces, taken);
            for (std::size_t i = 0; i < body_.face_columns.size(); ++i) {
                if (body_.face_columns[i].role != PlyRole::none) body_.face_numbers.push_back(i);
            }
        }
        if (body_.strips) body_.strip_indices = find_indices(*body_.strips);
    }

    void warn_of_skipped() {
        for (const PlyElement& element : body_.header.elements) {
            if (!body_.is_needed(element)) {
                if (element.count > 0)
                    mesh_.warnings.add("elements of other kinds, skipped", body_.name, element.line,
                                       fmt::format("found {} of the element {}", element.count,
                                                   boxwood::quoted(element.name)));
                continue;
            }
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                const bool is_read = &element == body_.vertices ? !property.is_list
                                     : &element == body_.faces
                                         ? !property.is_list || i == body_.face_indices ||
                                               i == body_.face_texture_coordinates
                                         : i == body_.strip_indices;
                if (!is_read)
                    mesh_.warnings.add(
                        "properties without a use, skipped", body_.name, property.line,
                        fmt::format("found the {} {} of the element {}",
                                    property.is_list ? "list" : "number",
                                    boxwood::quoted(property.name), boxwood::quoted(element.name)));
            }
        }
    }

    void join() {
        std::size_t polygons = mesh_.faces.size(), strips = 0;
        for (PlyFaces& part : parts_) {
            part.polygons.first_face = polygons;
            polygons += part.polygons.faces.size();
        }
        for (PlyFaces& part : parts_) {
            part.strips.first_face = polygons + strips;
            strips += part.strips.faces.size();
        }
        if (polygons + strips > body_.max_faces)
            throw ParseError(body_.name, "",
                             fmt::format("found {} triangles, expected at most {}",
                                         polygons + strips, body_.max_faces));
        if (body_.faces && !body_.has_faces) join_polygons(polygons);
        if (strips > 0) join_strips(polygons + strips);
        for (const PlyFaces& part : parts_) mesh_.warnings.append(part.warnings);
    }

    void join_polygons(std::size_t triangles) {
        for_each_chunk(parts_, [this](PlyFaces& part) { mend(part); });
        resize_on_huge_pages(mesh_.faces, triangles);
        bind_columns(body_.face_columns, *body_.faces, ValuesOf::faces, triangles, mesh_);
        MeshValues<Vec2f>& texture = mesh_.attributes.texture_coordinates;
        if (body_.face_texture_coordinates) {
            texture.of = ValuesOf::corners;
            resize_on_huge_pages(texture.values, 3 * triangles);
        }
        for_each_chunk(parts_, [&](PlyFaces& part) {
            const PlyFaceBatch& batch = part.polygons;
            const std::size_t first = batch.first_face;
            std::copy(batch.faces.begin(), batch.faces.end(),
                      mesh_.faces.begin() + static_cast<std::ptrdiff_t>(first));
            for (std::size_t i = 0; i < batch.texture_faces.size(); ++i) {
                for (int k = 0; k < 3; ++k)
                    texture.values[3 * (first + i) + static_cast<std::size_t>(k)] =
                        batch.texture_coordinates[static_cast<std::size_t>(
                            batch.texture_faces[i][k])];
            }
            for (std::size_t k = 0; k < batch.numbers.size(); ++k) {
                const PlyColumn& column = body_.face_columns[body_.face_numbers[k]];
                for (std::size_t i = 0; i < batch.numbers[k].size(); ++i)
                    column.set(first + i, batch.numbers[k][i]);
            }
            part.polygons = {};
        });
    }

    void mend(PlyFaces& part) const {
        PlyFaceBatch& batch = part.polygons;
        std::vector<std::vector<Vec3i>*> others;
        if (!batch.texture_faces.empty()) others.push_back(&batch.texture_faces);
        const std::size_t unmended = mend_fans(mesh_.vertices, batch.fans, batch.faces, others);
        for (std::size_t i = 0; i < unmended; ++i)
            part.warnings.add("concave polygons of too many corners, cut into fans", body_.name, "",
                              fmt::format("found a concave polygon of more than {} corners",
                                          kMostClippedCorners));
        std::vector<PolygonFan>().swap(batch.fans);
    }

    /// Behind the other faces; what those have, strips don't.
    void join_strips(std::size_t faces) {
        mesh_.faces.resize(faces);
        for_each_chunk(parts_, [&](PlyFaces& part) {
            const auto first = static_cast<std::ptrdiff_t>(part.strips.first_face);
            std::copy(part.strips.faces.begin(), part.strips.faces.end(),
                      mesh_.faces.begin() + first);
            part.strips = {};
        });
        if (!body_.faces) return;
        MeshAttributes& attributes = mesh_.attributes;
        extend(attributes.normals, Vec3f(0, 0, 0));
        extend(attributes.texture_coordinates, Vec2f(0, 0));
        extend(attributes.colors, VertexColor(1, 1, 1, 1));
        for (MeshField& field : attributes.fields) {
            if (field.of == ValuesOf::faces)
                field.values.resize(faces, std::numeric_limits<double>::quiet_NaN());
        }
    }

    template <class Value>
    void extend(MeshValues<Value>& values, const Value& missing) const {
        if (values.is_empty() || values.of == ValuesOf::vertices) return;
        values.values.resize((values.of == ValuesOf::corners ? 3 : 1) * mesh_.faces.size(),
                             missing);
    }

    PlyBody body_;
    MeshData& mesh_ = body_.mesh;
    std::vector<PlyFaces> parts_;
};

}  // namespace

MeshData parse_ply(const MeshSource& source, const ReadOptions& options) {
    return PlyReader(source, options.limits).read();
}

}  // namespace boxwood
