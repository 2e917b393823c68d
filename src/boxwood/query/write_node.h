// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "boxwood/core/box.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Writes the boxes of the children, multiplied by scale, and the order of the children for each
/// octant, by the centres of the boxes. Empty boxes say that there is no child, or none to hit.
template <int N>
void write_boxes(const std::array<Box3f, N>& boxes, float scale, WideNode<N>& node) {
    std::array<Vec3f, N> center;
    std::array<bool, N> is_there;
    int count = 0;
    for (int i = 0; i < N; ++i) {
        for (int k = 0; k < 3; ++k) {
            node.slabs[k].lo[i] = scale * boxes[i].lo[k];
            node.slabs[k].hi[i] = scale * boxes[i].hi[k];
        }
        // A quarter of it, so that the sums below can't be infinite.
        center[i] = 0.125f * boxes[i].lo + 0.125f * boxes[i].hi;
        is_there[i] = !boxes[i].is_empty();
        count += is_there[i];
    }
    std::fill(node.order, node.order + N, 0);
    // Rays of the opposite octant meet them the other way round.
    for (std::uint32_t octant = 0; octant < 4; ++octant) {
        alignas(4 * N) float distance[N];
        std::fill_n(distance, N, std::numeric_limits<float>::infinity());
        for (int i = 0; i < N; ++i) {
            if (!is_there[i]) continue;
            distance[i] = (octant & 1 ? -center[i][0] : center[i][0]) +
                          (octant & 2 ? -center[i][1] : center[i][1]) + center[i][2];
        }
        for (int i = 0; i < N; ++i) {
            // How many are nearer; of equally near ones, how many come before it.
            int rank = 0;
            for (int j = 0; j < N; ++j) rank += distance[j] < distance[i];
            for (int j = 0; j < i; ++j) rank += distance[j] == distance[i];
            const int from_far = is_there[i] ? count - 1 - rank : rank;
            node.order[from_far] |= static_cast<std::uint32_t>(i) << (4 * octant);
            node.order[rank] |= static_cast<std::uint32_t>(i) << (4 * (7 - octant));
        }
    }
}

}  // namespace boxwood
