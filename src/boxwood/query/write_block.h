// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
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

constexpr std::uint32_t kEmptySlot = std::numeric_limits<std::uint32_t>::max();

/// Writes the triangles, multiplied by scale. Those with a corner that is not finite or beyond the
/// range of float get NaN corners, which nothing hits; false when there are any.
template <int N>
bool write_block(const MeshView& mesh, float scale, const BlockTriangles<N>& triangles,
                 TriangleBlock<N>& block) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    if (triangles.count < N) std::fill_n(&block.corner[0][0][0], 9 * N, kNaN);
    std::fill_n(block.triangle, N, kEmptySlot);
    bool all_in_range = true;
    for (int i = 0; i < triangles.count; ++i) {
        const std::uint32_t triangle = triangles.index[i];
        const bool is_in_range = is_in_float_range(mesh, triangle);
        all_in_range &= is_in_range;
        block.triangle[i] = triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3d& p = mesh.corner(triangle, corner);
            for (int k = 0; k < 3; ++k)
                block.corner[corner][k][i] = is_in_range ? static_cast<float>(scale * p[k]) : kNaN;
        }
    }
    return all_in_range;
}

/// The vertices of a compact block, each once; the first is for empty slots.
template <int N>
struct BlockVertices {
    std::array<std::uint32_t, 3 * N + 1> index;
    int count = 1;

    BlockVertices(const MeshView& mesh, const BlockTriangles<N>& triangles) {
        for (int i = 0; i < triangles.count; ++i) {
            if (!is_in_float_range(mesh, triangles.index[i])) continue;
            for (const int vertex : mesh.faces[triangles.index[i]]) {
                if (place_of(vertex) == count) index[count++] = static_cast<std::uint32_t>(vertex);
            }
        }
    }

    /// The number of vertices when it isn't there.
    int place_of(int vertex) const {
        int place = 1;
        while (place < count && index[place] != static_cast<std::uint32_t>(vertex)) ++place;
        return place;
    }
};

/// As places and the alignment of nodes have it.
template <int N>
std::size_t compact_block_bytes(const BlockVertices<N>& vertices) {
    const std::size_t bytes = 7 * N + 3 * sizeof(float) * static_cast<std::size_t>(vertices.count);
    constexpr std::size_t kUnit = std::max(kReferenceUnit, alignof(WideNode<N>));
    return (bytes + kUnit - 1) / kUnit * kUnit;
}

/// The same as write_block(), with each vertex once. Precondition: the vertices of these triangles.
template <int N>
bool write_compact_block(const MeshView& mesh, float scale, const BlockTriangles<N>& triangles,
                         const BlockVertices<N>& vertices, CompactBlock<N>& block) {
    float* place = block.vertices();
    for (int k = 0; k < 3; ++k) *place++ = std::numeric_limits<float>::quiet_NaN();
    for (int i = 1; i < vertices.count; ++i) {
        for (int k = 0; k < 3; ++k)
            *place++ = static_cast<float>(scale * mesh.vertices[vertices.index[i]][k]);
    }
    // Files hold the rest as well, so it is to be the same each time.
    std::byte* end = reinterpret_cast<std::byte*>(&block) + compact_block_bytes(vertices);
    std::fill(reinterpret_cast<std::byte*>(place), end, std::byte{0});
    std::fill_n(block.triangle, N, kEmptySlot);
    std::fill_n(&block.corner[0][0], 3 * N, std::uint8_t{0});
    bool all_in_range = true;
    for (int i = 0; i < triangles.count; ++i) {
        const std::uint32_t triangle = triangles.index[i];
        block.triangle[i] = triangle;
        const bool is_in_range = is_in_float_range(mesh, triangle);
        all_in_range &= is_in_range;
        if (!is_in_range) continue;
        for (int corner = 0; corner < 3; ++corner)
            block.corner[corner][i] =
                static_cast<std::uint8_t>(vertices.place_of(mesh.faces[triangle][corner]));
    }
    return all_in_range;
}

}  // namespace boxwood
