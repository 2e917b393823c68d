// SPDX-License-Identifier: Apache-2.0
// Corners are sorted by their vertex and all they say; those that are alike share a new vertex.
#include "boxwood/mesh/split_corners.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace boxwood {

namespace {

/// What one kind of values says of corner i of the mesh.
template <class Value>
const Value& value_at(const MeshView& mesh, const MeshValues<Value>& values, std::size_t corner) {
    switch (values.of) {
        case ValuesOf::vertices:
            return values.values[static_cast<std::size_t>(
                mesh.faces[corner / 3][static_cast<int>(corner % 3)])];
        case ValuesOf::faces:
            return values.values[corner / 3];
        default:
            return values.values[corner];
    }
}

/// Orders by bits, which NaN takes part in.
template <class Value>
int compared(const MeshView& mesh, const MeshValues<Value>& values, std::size_t a, std::size_t b) {
    if (values.is_empty() || values.of == ValuesOf::vertices) return 0;
    return std::memcmp(value_at(mesh, values, a).data(), value_at(mesh, values, b).data(),
                       sizeof(Value));
}

template <class Value>
void take(const MeshView& mesh, const MeshValues<Value>& from, std::span<const std::size_t> corners,
          MeshValues<Value>& to) {
    if (from.is_empty()) return;
    to.of = ValuesOf::vertices;
    to.values.reserve(corners.size());
    for (const std::size_t corner : corners) to.values.push_back(value_at(mesh, from, corner));
}

bool is_of_vertices(const MeshAttributes& all) {
    const auto fits = [](const auto& values) {
        return values.is_empty() || values.of == ValuesOf::vertices;
    };
    return fits(all.normals) && fits(all.texture_coordinates) && fits(all.colors);
}

}  // namespace

MeshData split_corners(MeshView mesh, const MeshAttributes& attributes) {
    MeshData result;
    result.attributes = attributes;
    if (is_of_vertices(attributes)) {
        result.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
        result.faces.assign(mesh.faces.begin(), mesh.faces.end());
        return result;
    }
    const auto vertex_of = [&](std::size_t corner) {
        return mesh.faces[corner / 3][static_cast<int>(corner % 3)];
    };
    const auto order = [&](std::size_t a, std::size_t b) {
        if (vertex_of(a) != vertex_of(b)) return vertex_of(a) < vertex_of(b) ? -1 : 1;
        if (const int by = compared(mesh, attributes.normals, a, b)) return by;
        if (const int by = compared(mesh, attributes.texture_coordinates, a, b)) return by;
        return compared(mesh, attributes.colors, a, b);
    };
    std::vector<std::size_t> corners(3 * mesh.faces.size());
    std::iota(corners.begin(), corners.end(), std::size_t{0});
    std::sort(corners.begin(), corners.end(), [&](std::size_t a, std::size_t b) {
        const int comparison = order(a, b);
        return comparison != 0 ? comparison < 0 : a < b;
    });

    result.faces.resize(mesh.faces.size());
    std::vector<std::size_t> firsts;  // of the corners that share a vertex
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i == 0 || order(corners[i - 1], corners[i]) != 0) {
            firsts.push_back(corners[i]);
            result.vertices.push_back(
                mesh.vertices[static_cast<std::size_t>(vertex_of(corners[i]))]);
        }
        result.faces[corners[i] / 3][static_cast<int>(corners[i] % 3)] =
            static_cast<int>(firsts.size() - 1);
    }
    result.attributes.normals = {};
    result.attributes.texture_coordinates = {};
    result.attributes.colors = {};
    take(mesh, attributes.normals, firsts, result.attributes.normals);
    take(mesh, attributes.texture_coordinates, firsts, result.attributes.texture_coordinates);
    take(mesh, attributes.colors, firsts, result.attributes.colors);
    for (MeshField& field : result.attributes.fields) {
        if (field.of != ValuesOf::vertices) continue;
        std::vector<double> values;
        values.reserve(firsts.size());
        for (const std::size_t corner : firsts)
            values.push_back(field.values[static_cast<std::size_t>(vertex_of(corner))]);
        field.values = std::move(values);
    }
    return result;
}

}  // namespace boxwood
