// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "boxwood/core/box.h"
#include "boxwood/core/float_bits.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Writes the boxes of the children, multiplied by scale, and the order of the children for each
/// octant, by the centres of the boxes. Empty boxes say that there is no child, or none to hit.
template <int N>
void write_boxes(const std::array<Box3f, N>& boxes, float scale, WideNode<N>& node) {
    using Slots = std::array<std::int32_t, N>;
    Slots is_there;
    std::array<float, N> center[3];
    int count = 0;
    for (int i = 0; i < N; ++i) {
        for (int k = 0; k < 3; ++k) {
            node.slabs[k].lo[i] = scale * boxes[i].lo[k];
            node.slabs[k].hi[i] = scale * boxes[i].hi[k];
        }
        is_there[i] = !boxes[i].is_empty();
        count += is_there[i];
    }
    for (int k = 0; k < 3; ++k) {
        // A quarter of it, so that the sums below can't be infinite.
        for (int i = 0; i < N; ++i)
            center[k][i] = 0.125f * node.slabs[k].lo[i] + 0.125f * node.slabs[k].hi[i];
    }
    std::fill(node.order, node.order + N, 0);
    // Rays of the opposite octant meet them the other way round.
    for (int octant = 0; octant < 4; ++octant) {
        const float x = octant & 1 ? -1.0f : 1.0f, y = octant & 2 ? -1.0f : 1.0f;
        // Numbers in the order of the distances, and no two the same: all vectors and no branch.
        Slots distance, rank = {}, near_first, far_first;
        for (int i = 0; i < N; ++i) {
            const auto bits = static_cast<std::int32_t>(
                bits_of(x * center[0][i] + y * center[1][i] + center[2][i]));
            const std::int32_t in_order = bits ^ (bits >> 31 & 0x7fffffff);
            distance[i] = ((is_there[i] != 0 ? in_order : 0x7fffffff) & -16) | i;
        }
        for (int j = 0; j < N; ++j) {
            for (int i = 0; i < N; ++i) rank[i] += distance[j] < distance[i];
        }
        for (int i = 0; i < N; ++i) {
            near_first[rank[i]] = i;
            far_first[is_there[i] != 0 ? count - 1 - rank[i] : rank[i]] = i;
        }
        for (int i = 0; i < N; ++i)
            node.order[i] |= static_cast<std::uint32_t>(far_first[i]) << (4 * octant) |
                             static_cast<std::uint32_t>(near_first[i]) << (4 * (7 - octant));
    }
}

}  // namespace boxwood
