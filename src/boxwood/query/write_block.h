// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Triangles that become a block.
template <int N>
struct BlockTriangles {
    std::array<std::uint32_t, N> index;
    int count = 0;

    /// Puts them in order, each once.
    void sort() {
        const auto end = index.begin() + count;
        if (std::is_sorted(index.begin(), end, std::less_equal<>())) return;
        // How many are lower is the place: no branch that depends on the order.
        std::array<std::uint32_t, N> sorted;
        for (int i = 0; i < count; ++i) {
            int place = 0;
            for (int j = 0; j < count; ++j) place += index[j] < index[i];
            for (int j = 0; j < i; ++j) place += index[j] == index[i];
            sorted[place] = index[i];
        }
        index = sorted;
        count = static_cast<int>(std::unique(index.begin(), index.begin() + count) - index.begin());
    }

    // Meshes lie in memory as they like, so what a block needs is asked for early: first the faces,
    // and when these are there the vertices.
    void fetch_faces(const MeshView& mesh) const {
        for (int i = 0; i < count; ++i) __builtin_prefetch(&mesh.faces[index[i]]);
    }
    void fetch_vertices(const MeshView& mesh) const {
        for (int i = 0; i < count; ++i) {
            for (int corner = 0; corner < 3; ++corner)
                __builtin_prefetch(&mesh.corner(index[i], corner));
        }
    }
};

/// Writes the triangles, multiplied by scale, but for those with a corner that is not finite or
/// beyond the range of float.
template <int N>
void write_block(const MeshView& mesh, float scale, const BlockTriangles<N>& triangles,
                 TriangleBlock<N>& block) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    if (triangles.count < N) std::fill_n(&block.corner[0][0][0], 9 * N, kNaN);
    std::fill_n(block.triangle, N, std::numeric_limits<std::uint32_t>::max());
    for (int i = 0; i < triangles.count; ++i) {
        const std::uint32_t triangle = triangles.index[i];
        bool is_in_range = true;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3d& p = mesh.corner(triangle, corner);
            for (int k = 0; k < 3; ++k) {
                is_in_range &= std::abs(p[k]) <= FLT_MAX;
                block.corner[corner][k][i] = static_cast<float>(scale * p[k]);
            }
        }
        if (is_in_range) {
            block.triangle[i] = triangle;
            continue;
        }
        for (int corner = 0; corner < 3; ++corner) {
            for (int k = 0; k < 3; ++k) block.corner[corner][k][i] = kNaN;
        }
    }
}

}  // namespace boxwood
