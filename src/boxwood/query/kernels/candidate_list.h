// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

/// Triangles that a ray may hit, by index or place, and how near at the least: a distance, or minus
/// an inverse depth. There is room for some more, as vectors are stored whole.
template <std::uint32_t kMost, std::uint32_t kSlack>
struct CandidateList {
    std::uint32_t count;
    std::uint32_t triangle[kMost + kSlack];
    float nearest[kMost + kSlack];

    /// Makes room for so many more, by dropping those that are farther than what is hit for sure.
    /// False when there are too many, which are counted as kMost + 1 from then on.
    BOXWOOD_KERNEL bool make_room(std::uint32_t more, float farthest) {
        if (count + more <= kMost) return true;
        if (count <= kMost) drop_hidden(farthest);
        if (count + more <= kMost) return true;
        count = kMost + 1;
        return false;
    }

    BOXWOOD_KERNEL void drop_hidden(float farthest) {
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            triangle[kept] = triangle[i];
            nearest[kept] = nearest[i];
            kept += nearest[i] <= farthest;
        }
        count = kept;
    }
};

}  // namespace boxwood
