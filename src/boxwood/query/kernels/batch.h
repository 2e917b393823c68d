// SPDX-License-Identifier: Apache-2.0
// Which kernel serves a batch of rays.
#pragma once

#include "boxwood/query/kernels/any_hit.h"
#include "boxwood/query/kernels/closest_hit.h"
#include "boxwood/query/kernels/wavefront.h"

namespace boxwood {

template <class S>
void closest_hits(const WideTreeView& tree, const Rayf* rays, Hitf* hits,
                  std::size_t count) noexcept {
    if (count < kFewRays || tree.stack_size > kWavefrontStack) {
        for (std::size_t i = 0; i < count; ++i) closest_hit<S>(tree, rays[i], hits[i]);
    } else if (tree.bytes > kLargeTree) {
        Wavefront<S, false, true>(tree, rays, hits, count).run();
    } else {
        Wavefront<S, false, false>(tree, rays, hits, count).run();
    }
}

template <class S>
void any_hits(const WideTreeView& tree, const Rayf* rays, bool* hits, std::size_t count) noexcept {
    if (count < kFewRays || tree.stack_size > kWavefrontStack) {
        for (std::size_t i = 0; i < count; ++i) hits[i] = any_hit<S>(tree, rays[i]);
    } else if (tree.bytes > kLargeTree) {
        Wavefront<S, true, true>(tree, rays, hits, count).run();
    } else {
        Wavefront<S, true, false>(tree, rays, hits, count).run();
    }
}

}  // namespace boxwood
