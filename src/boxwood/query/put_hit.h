// SPDX-License-Identifier: Apache-2.0
// A hit's place among many, whichever way these are kept: an array, columns, or whether there are
// any.
#pragma once

#include "boxwood/query/ray_columns.h"

namespace boxwood {

BOXWOOD_KERNEL void put_hit(Hitf* hits, std::size_t i, const Hitf& hit) { hits[i] = hit; }
BOXWOOD_KERNEL void put_hit(const HitColumns& hits, std::size_t i, const Hitf& hit) {
    hits.put(i, hit);
}
BOXWOOD_KERNEL void put_hit(bool* hits, std::size_t i, const Hitf& hit) {
    hits[i] = hit.triangle != Hitf::kNone;
}

/// Asks for the memory of a place that will be written.
BOXWOOD_KERNEL void fetch_place(Hitf* hits, std::size_t i) { __builtin_prefetch(hits + i, 1); }
BOXWOOD_KERNEL void fetch_place(const HitColumns& hits, std::size_t i) { hits.fetch(i); }
BOXWOOD_KERNEL void fetch_place(bool*, std::size_t) {}

}  // namespace boxwood
