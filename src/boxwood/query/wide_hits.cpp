// SPDX-License-Identifier: Apache-2.0
// One ray at a time; batches are in wide_batches.cpp.
#include "boxwood/query/wide_hits.h"

#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/scaled_hits.h"

namespace boxwood {

namespace {

/// The normal, back from the scale of the tree.
void unscale_normal(Hitf& hit, float scale) {
    const float inverse = 1 / scale;
    for (float& coordinate : hit.normal) coordinate = coordinate * inverse * inverse;
}

}  // namespace

std::optional<Hitf> closest_hit(const WideTree& tree, const Rayf& ray) noexcept {
    Hitf hit;
    closest_hit(tree, ray, hit);
    if (!hit.is_hit()) return std::nullopt;
    return hit;
}

void closest_hit(const WideTree& tree, const Rayf& ray, Hitf& hit) noexcept {
    if (tree.is_empty()) {
        hit = {};
        return;
    }
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    if (tree.scale() == 1) return kernels.closest_hit(tree.view(), ray, hit);
    hit = hit_on_scaled(tree, ray);
    unscale_normal(hit, tree.scale());
}

bool any_hit(const WideTree& tree, const Rayf& ray) noexcept {
    if (tree.is_empty()) return false;
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    if (tree.scale() == 1) return kernels.any_hit(tree.view(), ray);
    return kernels.any_hit(tree.view(), scaled(ray, tree.scale()));
}

void closest_hit(const WideTree& tree, const Rayf& ray, Hitf& hit, WideCounts& counts) noexcept {
    if (tree.is_empty()) {
        hit = {};
        return;
    }
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    kernels.closest_hit_counted(tree.view(), scaled(ray, tree.scale()), hit, counts);
    hit.t *= 1 / tree.scale();
    unscale_normal(hit, tree.scale());
}

bool any_hit(const WideTree& tree, const Rayf& ray, WideCounts& counts) noexcept {
    if (tree.is_empty()) return false;
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    return kernels.any_hit_counted(tree.view(), scaled(ray, tree.scale()), counts);
}

}  // namespace boxwood
