// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/repair.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;

/// Makes values of vertices follow: the first of its position's, as long as all of them have the
/// same bits; else each corner gets what its vertex had. The faces are still those of before.
template <class Values>
void weld_values(const std::vector<Vec3i>& faces, const std::vector<std::uint32_t>& firsts,
                 ValuesOf& of, Values& values) {
    if (values.empty() || of != ValuesOf::vertices) return;
    const auto differs = [&](std::size_t i) {
        return std::memcmp(&values[i], &values[firsts[i]], sizeof values[i]) != 0;
    };
    bool is_same = true;
    for (std::size_t i = 0; i < firsts.size() && is_same; ++i) is_same = !differs(i);
    if (is_same) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < firsts.size(); ++i) {
            if (firsts[i] == i) values[kept++] = values[i];
        }
        values.resize(kept);
        return;
    }
    Values corners(3 * faces.size());
    parallel_for(faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int k = 0; k < 3; ++k)
                corners[3 * i + static_cast<std::size_t>(k)] =
                    values[static_cast<std::size_t>(faces[i][k])];
        }
    });
    of = ValuesOf::corners;
    values = std::move(corners);
}

}  // namespace

std::size_t weld_vertices(MeshData& mesh) {
    const std::size_t before = mesh.vertices.size();
    const std::vector<std::uint32_t> firsts = first_at_position(mesh.vertices);
    MeshAttributes& attributes = mesh.attributes;
    weld_values(mesh.faces, firsts, attributes.normals.of, attributes.normals.values);
    weld_values(mesh.faces, firsts, attributes.texture_coordinates.of,
                attributes.texture_coordinates.values);
    weld_values(mesh.faces, firsts, attributes.colors.of, attributes.colors.values);
    for (MeshField& field : attributes.fields)
        weld_values(mesh.faces, firsts, field.of, field.values);

    std::vector<int> places(before);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < before; ++i) {
        if (firsts[i] == i) {
            mesh.vertices[kept] = mesh.vertices[i];
            places[i] = static_cast<int>(kept++);
        } else {
            places[i] = places[firsts[i]];
        }
    }
    mesh.vertices.resize(kept);
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int& index : mesh.faces[i]) index = places[static_cast<std::size_t>(index)];
        }
    });
    return before - kept;
}

}  // namespace boxwood
