// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "boxwood/core/vectors.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

constexpr std::uint32_t kEmptySlot = std::numeric_limits<std::uint32_t>::max();

/// Triangles that become a block.
template <int N>
struct BlockTriangles {
    std::array<std::uint32_t, N> index;
    int count = 0;

    /// Puts them in order, each once.
    void sort() {
        // How many are lower is the place: no branch that depends on the order, and compilers
        // compare one with all others in vectors.
        std::array<std::int32_t, N> triangle, place = {};
        triangle.fill(std::numeric_limits<std::int32_t>::max());
        for (int i = 0; i < count; ++i) triangle[i] = static_cast<std::int32_t>(index[i]);
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < N; ++j) place[j] += triangle[i] < triangle[j];
        }
        // Those that are there twice leave places empty.
        index.fill(kEmptySlot);
        for (int i = 0; i < count; ++i) index[place[i]] = static_cast<std::uint32_t>(triangle[i]);
        const auto end = std::remove(index.begin(), index.begin() + count, kEmptySlot);
        count = static_cast<int>(end - index.begin());
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

/// The coordinates of four points, multiplied by scale and rounded to float: x, y and z.
inline std::array<Float4, 3> transposed(const std::array<const Vec3d*, 4>& points, double scale) {
    using Float2 = float __attribute__((vector_size(8)));
    const auto narrowed = [&](const Double2& x) {
        return __builtin_convertvector(scale * x, Float2);
    };
    const auto xy = [&](int i) {
        Double2 pair;
        std::memcpy(&pair, points[i]->data(), sizeof pair);
        return narrowed(pair);
    };
    const auto z = [&](int i) { return narrowed(Double2{points[i]->z(), points[i + 1]->z()}); };
    const Float4 first = __builtin_shufflevector(xy(0), xy(1), 0, 2, 1, 3);
    const Float4 second = __builtin_shufflevector(xy(2), xy(3), 0, 2, 1, 3);
    return {__builtin_shufflevector(first, second, 0, 1, 4, 5),
            __builtin_shufflevector(first, second, 2, 3, 6, 7),
            __builtin_shufflevector(z(0), z(2), 0, 1, 2, 3)};
}

/// Writes the triangles, multiplied by scale. Those with a corner that is not finite or beyond the
/// range of float get NaN corners, which nothing hits; false when there are any. Precondition:
/// scale is a power of two.
template <int N>
bool write_block(const MeshView& mesh, float scale, const BlockTriangles<N>& triangles,
                 TriangleBlock<N>& block) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    // What is less as a float multiplied by scale is within the range of float without it.
    const float limit = FLT_MAX * std::min(scale, 1.0f);
    for (int i = 0; i < N; ++i)
        block.triangle[i] = i < triangles.count ? triangles.index[i] : kEmptySlot;
    Int4 is_in_range = Int4{} - 1;
    for (int i = 0; i < N; i += 4) {
        // Where there are fewer than four, the last one stands in for those that are missing.
        const Int4 is_there = Int4{0, 1, 2, 3} + i < triangles.count;
        std::array<const Vec3i*, 4> faces = {};
        for (int j = 0; j < 4 && i < triangles.count; ++j)
            faces[j] = &mesh.faces[triangles.index[std::min(i + j, triangles.count - 1)]];
        for (int corner = 0; corner < 3; ++corner) {
            std::array<Float4, 3> rows = {Float4{} + kNaN, Float4{} + kNaN, Float4{} + kNaN};
            if (i < triangles.count) {
                std::array<const Vec3d*, 4> points;
                for (int j = 0; j < 4; ++j) points[j] = &mesh.vertices[(*faces[j])[corner]];
                rows = transposed(points, scale);
                for (Float4& row : rows) {
                    is_in_range &= (row < limit) & (row > -limit);
                    row = is_there ? row : Float4{} + kNaN;
                }
            }
            for (int k = 0; k < 3; ++k)
                std::memcpy(&block.corner[corner][k][i], &rows[k], sizeof rows[k]);
        }
    }
    if (all_of(is_in_range)) return true;
    bool all_in_range = true;
    for (int triangle = 0; triangle < triangles.count; ++triangle) {
        if (is_in_float_range(mesh, triangles.index[triangle])) continue;
        all_in_range = false;
        for (auto& corner : block.corner) {
            for (float* row : corner) row[triangle] = kNaN;
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
