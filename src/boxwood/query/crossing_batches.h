// SPDX-License-Identifier: Apache-2.0
// Batches of the queries for more than one hit, on a mesh or in a scene.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/query/crossings.h"
#include "boxwood/query/hit_lists.h"

namespace boxwood {

/// Rays between two looks at whether to go on: few, as by brute force each may take long.
constexpr std::size_t kRaysOfPiece = 256;

/// The crossings that add(i, hits) adds to `hits`, in any order, for each of that many rays. While
/// at work it takes, beside the result, room for the hits once more.
template <class Add>
HitLists crossings_of_all(std::size_t rays, const BatchOptions& options, const Add& add) {
    HitLists lists;
    lists.offsets.resize(rays + 1);
    std::vector<std::vector<Hit>> pieces((rays + kRaysOfPiece - 1) / kRaysOfPiece);
    for_each_piece(rays, kRaysOfPiece, options, [&](std::size_t begin, std::size_t end) {
        std::vector<Hit> found;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t before = found.size();
            add(i, found);
            sort_crossings(found, before);
            lists.offsets[i + 1] = found.size() - before;
        }
        pieces[begin / kRaysOfPiece].assign(found.begin(), found.end());
    });
    for (std::size_t i = 0; i < rays; ++i) lists.offsets[i + 1] += lists.offsets[i];

    const std::size_t total = lists.offsets.back();
    for (auto* numbers : {&lists.t, &lists.u, &lists.v}) numbers->resize(total);
    for (auto* indices : {&lists.triangle, &lists.instance}) indices->resize(total);
    const BatchOptions unwatched = {.on_this_thread = options.on_this_thread};
    for_each_piece(pieces.size(), 1, unwatched, [&](std::size_t piece, std::size_t) {
        std::size_t place = lists.offsets[piece * kRaysOfPiece];
        for (const Hit& hit : pieces[piece]) {
            lists.t[place] = hit.t;
            lists.u[place] = hit.u;
            lists.v[place] = hit.v;
            lists.triangle[place] = hit.triangle;
            lists.instance[place++] = hit.instance;
        }
    });
    return lists;
}

/// How many crossings add(i, hits) adds, each counted once, for each place in counts.
template <class Add>
void count_crossings_of_all(std::span<std::size_t> counts, const BatchOptions& options,
                            const Add& add) {
    for_each_piece(counts.size(), kRaysOfPiece, options, [&](std::size_t begin, std::size_t end) {
        std::vector<Hit> found;
        for (std::size_t i = begin; i < end; ++i) {
            found.clear();
            add(i, found);
            sort_crossings(found);
            counts[i] = found.size();
        }
    });
}

/// first_k(i, row) for each row of k places.
template <class FirstK>
void first_crossings_of_all(std::size_t rays, std::size_t k, std::span<Hit> hits,
                            const BatchOptions& options, const FirstK& first_k) {
    for_each_piece(rays, kRaysOfPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) first_k(i, hits.subspan(i * k, k));
    });
}

}  // namespace boxwood
