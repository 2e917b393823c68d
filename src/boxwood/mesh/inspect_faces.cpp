// SPDX-License-Identifier: Apache-2.0
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/face_edges.h"
#include "boxwood/mesh/inspect_parts.h"
#include "boxwood/mesh/union_find.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;

std::size_t count_degenerate(MeshView mesh) {
    return parallel_reduce(
        mesh.faces.size(), kPiece, std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::size_t count = 0;
            for (std::size_t i = begin; i < end; ++i)
                count += !is_in_float_range(mesh, i) || has_zero_area(mesh, i);
            return count;
        },
        [](std::size_t a, std::size_t b) { return a + b; });
}

/// Faces that count as absent are no duplicates.
std::size_t count_duplicates(MeshView mesh, PositionNames names) {
    using Corners = std::array<std::uint32_t, 3>;
    constexpr Corners kAbsent = {0, 0, 0};
    std::vector<Corners> faces(mesh.faces.size(), kAbsent);
    parallel_for(mesh.faces.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!has_edges(mesh, names, i)) continue;
            const Vec3i& face = mesh.faces[i];
            faces[i] = {names[face[0]], names[face[1]], names[face[2]]};
            std::sort(faces[i].begin(), faces[i].end());
        }
    });
    tbb::parallel_sort(faces);
    std::size_t count = 0;
    for (std::size_t i = 1; i < faces.size(); ++i)
        count += faces[i] == faces[i - 1] && faces[i] != kAbsent;
    return count;
}

std::size_t count_components(MeshView mesh, PositionNames names) {
    UnionFind sets(mesh.vertices.size());
    std::vector<bool> is_corner(mesh.vertices.size(), false);
    for (const Vec3i& face : mesh.faces) {
        for (const int index : face) {
            is_corner[names[static_cast<std::size_t>(index)]] = true;
            sets.join(names[face[0]], names[static_cast<std::size_t>(index)]);
        }
    }
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < is_corner.size(); ++i) count += is_corner[i] && sets.find(i) == i;
    return count;
}

}  // namespace

void inspect_faces(MeshView mesh, PositionNames names, MeshReport& report) {
    report.degenerate_faces = count_degenerate(mesh);
    report.duplicate_faces = count_duplicates(mesh, names);
    report.components = count_components(mesh, names);
}

}  // namespace boxwood
