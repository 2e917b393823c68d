// SPDX-License-Identifier: Apache-2.0
// How one vertex, face or strip is read, in text as in binary files. A cursor knows how numbers
// are written there:
//
//     double number(PlyType type);          the next number
//     std::int64_t integer(PlyType type);   the next number, which must be whole
//     std::size_t count(PlyType type);      the count of the next list, 0 or more
//     void skip(PlyType type);              past the next number
//     void fail(const std::string&);        throws a ParseError with the place of what was read
//     last void warn(Warnings&, const char* kind, const std::string&);
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "boxwood/mesh/ply/ply_body.h"
#include "boxwood/mesh/reader_warnings.h"

namespace boxwood {

template <class Cursor>
void skip_ply_list(Cursor& cursor, const PlyProperty& property) {
    const std::size_t count = cursor.count(property.count_type);
    for (std::size_t i = 0; i < count; ++i) cursor.skip(property.type);
}

template <class Cursor>
void read_ply_vertex(Cursor& cursor, PlyBody& body, std::size_t row) {
    for (std::size_t i = 0; i < body.vertex_columns.size(); ++i) {
        const PlyProperty& property = body.vertices->properties[i];
        if (property.is_list) {
            skip_ply_list(cursor, property);
        } else {
            body.vertex_columns[i].set(row, cursor.number(property.type));
        }
    }
    if (!body.mesh.vertices[row].allFinite()) body.has_unfinite_vertices = true;
}

/// Appends the list's indices, which must be those of vertices, or from the given least one on.
template <class Cursor>
void read_ply_indices(Cursor& cursor, const PlyProperty& property, const PlyBody& body,
                      const char* what, std::size_t row, int least, std::vector<int>& indices) {
    const auto vertices = static_cast<std::int64_t>(body.vertices->count);
    const std::size_t count = cursor.count(property.count_type);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t index = cursor.integer(property.type);
        if (index < least || index >= vertices)
            cursor.fail(fmt::format("{} {} has vertex index {}, {}", what, row, index,
                                    vertices > 0
                                        ? fmt::format("expected {} to {}", least, vertices - 1)
                                        : "but there are no vertices"));
        indices.push_back(static_cast<int>(index));
    }
}

/// The polygon is scratch memory.
template <class Cursor>
void read_ply_face(Cursor& cursor, const PlyBody& body, std::size_t row, PlyPolygon& polygon,
                   PlyFaces& faces) {
    polygon.corners.clear();
    polygon.texture_coordinates.clear();
    polygon.numbers.resize(body.face_columns.size());
    for (std::size_t i = 0; i < body.face_columns.size(); ++i) {
        const PlyProperty& property = body.faces->properties[i];
        if (i == body.face_indices) {
            read_ply_indices(cursor, property, body, "face", row, 0, polygon.corners);
        } else if (i == body.face_texture_coordinates) {
            const std::size_t count = cursor.count(property.count_type);
            for (std::size_t k = 0; k < count; ++k)
                polygon.texture_coordinates.push_back(
                    static_cast<float>(cursor.number(property.type)));
        } else if (property.is_list) {
            skip_ply_list(cursor, property);
        } else {
            polygon.numbers[i] = cursor.number(property.type);
        }
    }
    const std::size_t corners = polygon.corners.size();
    if (corners < 3)
        return cursor.warn(
            faces.warnings, kFewCorners,
            fmt::format("face {} has {} corners, expected at least 3", row, corners));
    const std::size_t most = body.max_faces - faces.polygons.faces.size();
    if (corners - 2 > most)
        cursor.fail(
            fmt::format("found more than {} triangles, expected at most that", body.max_faces));
    // Each of its triangles gets all numbers of a polygon, which a file could make very many.
    const std::size_t numbers = body.face_numbers.size();
    constexpr std::size_t kMostCopies = 32;
    if (numbers > kMostCopies && corners - 2 > kMostCopies * (corners + numbers) / numbers)
        cursor.fail(fmt::format("face {} has {} corners and {} numbers, expected fewer of them",
                                row, corners, numbers));
    constexpr std::size_t kMostIndices = std::numeric_limits<int>::max();
    if (corners > kMostIndices - faces.polygons.texture_coordinates.size())
        cursor.fail(fmt::format("face {} has {} corners, too many for this part of the file", row,
                                corners));
    const std::size_t texture_numbers = polygon.texture_coordinates.size();
    if (body.face_texture_coordinates && texture_numbers != 2 * corners)
        cursor.warn(faces.warnings, "faces without texture coordinates, given zeros",
                    fmt::format("face {} has {} numbers for texture coordinates, expected {}", row,
                                texture_numbers, 2 * corners));
    faces.polygons.add(polygon, body.face_numbers, body.face_texture_coordinates.has_value());
}

template <class Cursor>
void read_ply_strips(Cursor& cursor, const PlyBody& body, std::size_t row,
                     std::vector<int>& indices, PlyFaces& faces) {
    indices.clear();
    for (std::size_t i = 0; i < body.strips->properties.size(); ++i) {
        const PlyProperty& property = body.strips->properties[i];
        if (i == body.strip_indices) {
            read_ply_indices(cursor, property, body, "strip", row, -1, indices);
        } else if (property.is_list) {
            skip_ply_list(cursor, property);
        } else {
            cursor.skip(property.type);
        }
    }
    if (indices.size() > body.max_faces - faces.strips.faces.size())
        cursor.fail(fmt::format("found a strip of {} indices, expected at most {}", indices.size(),
                                body.max_faces));
    const std::size_t left_out = faces.strips.add_strip(indices);
    if (left_out > 0)
        cursor.warn(faces.warnings, "strips with triangles of two equal corners, left out",
                    fmt::format("strip {} has {} of them", row, left_out));
}

}  // namespace boxwood
