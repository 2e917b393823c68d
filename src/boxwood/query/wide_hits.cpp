// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_hits.h"

#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

namespace {

WideTreeView view(const WideTree& tree) {
    WideTreeView result = {.memory = tree.memory(), .lo = {}, .hi = {}};
    for (int k = 0; k < 3; ++k) {
        result.lo[k] = tree.bounds().lo[k];
        result.hi[k] = tree.bounds().hi[k];
    }
    return result;
}

}  // namespace

std::optional<Hitf> closest_hit(const WideTree& tree, const Rayf& ray) noexcept {
    if (tree.is_empty()) return std::nullopt;
    Hitf hit;
    ray_kernels(tree.instruction_set()).closest_hit(view(tree), ray, hit);
    if (!hit.is_hit()) return std::nullopt;
    return hit;
}

bool any_hit(const WideTree& tree, const Rayf& ray) noexcept {
    return !tree.is_empty() && ray_kernels(tree.instruction_set()).any_hit(view(tree), ray);
}

}  // namespace boxwood
