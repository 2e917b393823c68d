// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/traverse.h"

namespace boxwood {

WalkEntry find_back(const Tree& tree, SlabRay slabs, double t_min, double t_max, std::uint32_t done,
                    std::uint32_t top) noexcept {
    const auto enter = [&](std::uint32_t node) {
        return WalkEntry{node, slabs.intersect(tree.nodes[node].box, t_min, t_max)};
    };
    while (done != top) {
        const std::uint32_t parent = tree.parents[done];
        WalkEntry near = enter(tree.nodes[parent].left()), far = enter(tree.nodes[parent].right());
        if (far.t < near.t) std::swap(near, far);
        // Which one is near comes out as on the way down. Where t_max has passed the near child
        // since, it has passed the far one too.
        if (done == near.node && far.t != SlabRay::kMiss) return far;
        done = parent;
    }
    return {top, SlabRay::kMiss};
}

}  // namespace boxwood
