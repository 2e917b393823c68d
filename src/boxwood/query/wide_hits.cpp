// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_hits.h"

#include <algorithm>

#include "boxwood/core/parallel.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/kernels/ray_kernels.h"

namespace boxwood {

namespace {

/// Rays of one task: whole groups of rays, so that a camera's tiles stay together; enough for a
/// wavefront to run long, few enough to share out evenly.
std::size_t piece_of(std::size_t count) {
    constexpr std::size_t kGroup = 256, kLeast = 8 * kGroup, kMost = 64 * kGroup;
    constexpr std::size_t kTurns = 8;  ///< of each thread
    const std::size_t even = count / (kTurns * thread_count()) / kGroup * kGroup;
    return std::clamp(even, kLeast, kMost);
}

Rayf scaled(Rayf ray, float scale) {
    for (float& coordinate : ray.origin) coordinate *= scale;
    ray.t_min *= scale;
    ray.t_max *= scale;
    return ray;
}

/// Back from the scale of the tree.
void unscale(Hitf& hit, float scale) {
    if (!hit.is_hit()) return;
    const float inverse = 1 / scale;
    hit.t *= inverse;
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
    kernels.closest_hit(tree.view(), scaled(ray, tree.scale()), hit);
    unscale(hit, tree.scale());
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
    unscale(hit, tree.scale());
}

bool any_hit(const WideTree& tree, const Rayf& ray, WideCounts& counts) noexcept {
    if (tree.is_empty()) return false;
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    return kernels.any_hit_counted(tree.view(), scaled(ray, tree.scale()), counts);
}

void closest_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<Hitf> hits,
                  const BatchOptions& options) {
    check_hit_places(rays.size(), hits.size());
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    const auto trace = [&](std::size_t begin, std::size_t end) {
        if (tree.scale() == 1 && !tree.is_empty()) {
            kernels.closest_hits(tree.view(), rays.data() + begin, hits.data() + begin,
                                 end - begin);
        } else {
            for (std::size_t i = begin; i < end; ++i) closest_hit(tree, rays[i], hits[i]);
        }
    };
    for_each_piece(rays.size(), piece_of(rays.size()), options, trace);
}

void any_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<bool> hits,
              const BatchOptions& options) {
    check_hit_places(rays.size(), hits.size());
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    const auto trace = [&](std::size_t begin, std::size_t end) {
        if (tree.scale() == 1 && !tree.is_empty()) {
            kernels.any_hits(tree.view(), rays.data() + begin, hits.data() + begin, end - begin);
        } else {
            for (std::size_t i = begin; i < end; ++i) hits[i] = any_hit(tree, rays[i]);
        }
    };
    for_each_piece(rays.size(), piece_of(rays.size()), options, trace);
}

}  // namespace boxwood
