// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_hits.h"

#include <algorithm>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

namespace {

/// Rays of one task: enough to fill a wavefront many times, few enough to share out evenly.
constexpr std::size_t kPiece = 2048;

void check_sizes(std::size_t rays, std::size_t hits) {
    if (rays != hits)
        throw InvalidInput("closest_hits, any_hits: expected as many places for hits as rays");
}

}  // namespace

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

void closest_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<Hitf> hits) {
    check_sizes(rays.size(), hits.size());
    if (tree.is_empty()) return std::fill(hits.begin(), hits.end(), Hitf{}), void();
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    parallel_for(rays.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        kernels.closest_hits(tree.view(), rays.data() + begin, hits.data() + begin, end - begin);
    });
}

void any_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<bool> hits) {
    check_sizes(rays.size(), hits.size());
    if (tree.is_empty()) return std::fill(hits.begin(), hits.end(), false), void();
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    parallel_for(rays.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        kernels.any_hits(tree.view(), rays.data() + begin, hits.data() + begin, end - begin);
    });
}

}  // namespace boxwood
