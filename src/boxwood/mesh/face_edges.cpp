// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/face_edges.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

namespace boxwood {

std::vector<FaceEdge> sorted_face_edges(MeshView mesh, std::span<const std::uint32_t> names) {
    std::vector<FaceEdge> edges;
    edges.reserve(3 * mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (!has_edges(mesh, names, i)) continue;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = names[mesh.faces[i][k]];
            const std::uint32_t to = names[mesh.faces[i][(k + 1) % 3]];
            const auto [low, high] = std::minmax(from, to);
            edges.push_back({.ends = std::uint64_t{low} << 32 | high,
                             .face = static_cast<std::uint32_t>(i),
                             .side = static_cast<std::uint8_t>(k),
                             .is_upward = from < to});
        }
    }
    tbb::parallel_sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.face < b.face;
    });
    return edges;
}

}  // namespace boxwood
