// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>
#include <span>

#include "boxwood/core/batch.h"
#include "boxwood/query/ray_order.h"

namespace boxwood {

/// The room that threads have for pieces of rays and their hits.
template <class Ray, class Hit>
using RayPieces = tbb::enumerable_thread_specific<RayPiece<Ray, Hit>>;

/// Answers the rays of a camera in tiles of its rows, on all cores; false where rays come in no
/// rows. ray_at(i) is the i-th of `count` rays, trace(rays, hits) answers some of them, and put(i,
/// hit) keeps the answer of the i-th.
template <class Ray, class Hit, class RayAt, class Trace, class Put>
bool answer_in_tiles(std::size_t count, const BatchOptions& options, const RayAt& ray_at,
                     const Trace& trace, const Put& put) {
    const std::size_t row = row_length(count, ray_at);
    if (row == 0) return false;
    const RayOrder order(count, row);
    RayPieces<Ray, Hit> pieces;
    for_each_piece(order.pieces(), 1, options, [&](std::size_t i, std::size_t) {
        RayPiece<Ray, Hit>& piece = pieces.local();
        piece.take(order, i, ray_at);
        trace(std::span<const Ray>(piece.rays), std::span<Hit>(piece.hits));
        piece.for_each([&](std::size_t in_batch, std::size_t in_piece) {
            put(in_batch, piece.hits[in_piece]);
        });
    });
    return true;
}

}  // namespace boxwood
