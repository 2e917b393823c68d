// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/off/off_vertices.h"

#include <fmt/format.h>

#include <cfloat>
#include <cmath>

#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/mesh/reader_warnings.h"

namespace boxwood {

namespace {

bool is_in_float_range(const Vec3d& p) {
    return std::abs(p.x()) <= FLT_MAX && std::abs(p.y()) <= FLT_MAX && std::abs(p.z()) <= FLT_MAX;
}

}  // namespace

void resize_off_vertices(const OffHeader& header, MeshData& mesh) {
    resize_on_huge_pages(mesh.vertices, header.vertices);
    if (header.has_normals) mesh.attributes.normals.values.resize(header.vertices);
    if (header.has_colors) mesh.attributes.colors.values.resize(header.vertices);
    if (header.has_texture_coordinates)
        mesh.attributes.texture_coordinates.values.resize(header.vertices);
}

void set_off_vertex(const OffHeader& header, const std::string& file, const OffVertex& vertex,
                    std::size_t i, const OffPlace& place, MeshData& mesh, OffVertices& part) {
    Vec3d position = vertex.position;
    if (header.is_homogeneous) {
        if (vertex.w == 0)
            throw ParseError(file, place.text(),
                             fmt::format("vertex {} has 0 as its fourth coordinate, expected a "
                                         "number to divide the others by",
                                         i));
        position /= vertex.w;
    }
    if (!is_in_float_range(position)) {
        const bool is_finite = position.allFinite();
        part.warnings.add_lazily(is_finite ? kBeyondFloat : kNotFinite, file, [&] {
            return std::pair(
                place.text(),
                fmt::format("vertex {} is ({}, {}, {}), expected {}", i, position.x(), position.y(),
                            position.z(), is_finite ? "at most 3.4e38 in size" : "finite numbers"));
        });
    }
    mesh.vertices[i] = position;
    if (header.has_normals) mesh.attributes.normals.values[i] = vertex.normal;
    if (header.has_texture_coordinates)
        mesh.attributes.texture_coordinates.values[i] = vertex.texture_coordinates;
    if (header.has_colors) {
        warn_of_off_color(part.warnings, file, vertex.color, place);
        mesh.attributes.colors.values[i] = unscaled(vertex.color, part.largest_color);
    }
}

}  // namespace boxwood
