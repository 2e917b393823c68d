// SPDX-License-Identifier: Apache-2.0
// A hit's place among many, whichever way these are kept: an array or columns.
#pragma once

#include "boxwood/query/ray_columns.h"

namespace boxwood {

BOXWOOD_KERNEL void put_hit(Hitf* hits, std::size_t i, const Hitf& hit) { hits[i] = hit; }
BOXWOOD_KERNEL void put_hit(const HitColumns& hits, std::size_t i, const Hitf& hit) {
    hits.t[i] = hit.t;
    hits.triangle[i] = hit.triangle;
    hits.instance[i] = hit.triangle == Hitf::kNone ? Hitf::kNone : hit.instance;
    hits.uv[2 * i] = hit.u;
    hits.uv[2 * i + 1] = hit.v;
    // In double, where no square of a float is too large or too small.
    const double x = hit.normal[0], y = hit.normal[1], z = hit.normal[2];
    const double squared = x * x + y * y + z * z;
    const double factor = squared > 0 ? 1 / __builtin_sqrt(squared) : 0;
    hits.normal[3 * i] = static_cast<float>(factor * x);
    hits.normal[3 * i + 1] = static_cast<float>(factor * y);
    hits.normal[3 * i + 2] = static_cast<float>(factor * z);
}

/// Asks for the memory of a place that will be written.
BOXWOOD_KERNEL void fetch_place(Hitf* hits, std::size_t i) { __builtin_prefetch(hits + i, 1); }
BOXWOOD_KERNEL void fetch_place(const HitColumns& hits, std::size_t i) {
    __builtin_prefetch(hits.t + i, 1);
    __builtin_prefetch(hits.triangle + i, 1);
    __builtin_prefetch(hits.instance + i, 1);
    __builtin_prefetch(hits.uv + 2 * i, 1);
    __builtin_prefetch(hits.normal + 3 * i, 1);
}

}  // namespace boxwood
