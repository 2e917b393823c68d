// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_hits.h"

#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

std::optional<Hitf> closest_hit(const WideTree& tree, const Rayf& ray) noexcept {
    if (tree.is_empty()) return std::nullopt;
    Hitf hit;
    ray_kernels(tree.instruction_set()).closest_hit(tree.view(), ray, hit);
    if (!hit.is_hit()) return std::nullopt;
    return hit;
}

bool any_hit(const WideTree& tree, const Rayf& ray) noexcept {
    return !tree.is_empty() && ray_kernels(tree.instruction_set()).any_hit(tree.view(), ray);
}

}  // namespace boxwood
