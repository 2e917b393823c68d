// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/wide_node.h"

namespace boxwood {

/// The block at a place, spread out in the room that is given if the tree is compact.
template <int N>
BOXWOOD_KERNEL const TriangleBlock<N>& block_at(const WideTreeView& tree, WideReference reference,
                                                TriangleBlock<N>& room) {
    const std::byte* place = tree.memory + byte_offset(reference);
    if (__builtin_expect(!tree.is_compact, 1))
        return *reinterpret_cast<const TriangleBlock<N>*>(place);
    const auto& block = *reinterpret_cast<const CompactBlock<N>*>(place);
    for (int i = 0; i < N; ++i) room.triangle[i] = block.triangle[i];
    for (int corner = 0; corner < 3; ++corner) {
        for (int i = 0; i < N; ++i) {
            const float* vertex = block.vertices() + 3 * block.corner[corner][i];
            for (int k = 0; k < 3; ++k) room.corner[corner][k][i] = vertex[k];
        }
    }
    return room;
}

/// One triangle of a block.
struct BlockTriangle {
    float corner[3][3];  ///< [a, b, c][x, y, z]
    std::uint32_t index;
};

/// (b - a) x (c - a).
BOXWOOD_KERNEL void normal_of(const BlockTriangle& triangle, float (&normal)[3]) {
    float ab[3], ac[3];
    for (int k = 0; k < 3; ++k) {
        ab[k] = triangle.corner[1][k] - triangle.corner[0][k];
        ac[k] = triangle.corner[2][k] - triangle.corner[0][k];
    }
    for (int k = 0; k < 3; ++k) {
        const int i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
        normal[k] = ab[i] * ac[j] - ab[j] * ac[i];
    }
}

template <int N>
BOXWOOD_KERNEL BlockTriangle triangle_at(const WideTreeView& tree, WideReference reference,
                                         unsigned lane) {
    const std::byte* place = tree.memory + byte_offset(reference);
    BlockTriangle triangle;
    if (__builtin_expect(!tree.is_compact, 1)) {
        const auto& block = *reinterpret_cast<const TriangleBlock<N>*>(place);
        triangle.index = block.triangle[lane];
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) triangle.corner[i][k] = block.corner[i][k][lane];
        }
    } else {
        const auto& block = *reinterpret_cast<const CompactBlock<N>*>(place);
        triangle.index = block.triangle[lane];
        for (int i = 0; i < 3; ++i) {
            const float* vertex = block.vertices() + 3 * block.corner[i][lane];
            for (int k = 0; k < 3; ++k) triangle.corner[i][k] = vertex[k];
        }
    }
    return triangle;
}

}  // namespace boxwood
