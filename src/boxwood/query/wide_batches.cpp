// SPDX-License-Identifier: Apache-2.0
// Many rays at a time, in arrays or in columns, on all cores.
#include <algorithm>

#include "boxwood/core/parallel.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/put_hit.h"
#include "boxwood/query/ray_tiles.h"
#include "boxwood/query/scaled_hits.h"
#include "boxwood/query/wide_hits.h"

namespace boxwood {

namespace {

constexpr std::size_t kGroup = 256;  ///< rays that a frustum takes at the most

/// Whether kernels for many rays take the tree as it is.
bool is_plain(const WideTree& tree) { return tree.scale() == 1 && !tree.is_empty(); }

/// Rays of one task, where they are taken as they are: whole groups of rays, so that a camera's
/// tiles stay together; enough for a wavefront to run long, few enough to share out evenly.
std::size_t piece_of(std::size_t count) {
    constexpr std::size_t kLeast = 8 * kGroup, kMost = 64 * kGroup;
    constexpr std::size_t kTurns = 8;  ///< of each thread
    const std::size_t even = count / (kTurns * thread_count()) / kGroup * kGroup;
    return std::clamp(even, kLeast, kMost);
}

/// The closest hits of some rays, on this thread.
void trace(const WideTree& tree, std::span<const Rayf> rays, Hitf* hits) {
    if (is_plain(tree)) {
        const RayKernels& kernels = ray_kernels(tree.instruction_set());
        kernels.closest_hits(tree.view(), rays.data(), hits, rays.size());
    } else {
        for (std::size_t i = 0; i < rays.size(); ++i) closest_hit(tree, rays[i], hits[i]);
    }
}

/// Those of a camera, in tiles of its rows; false where rays come in no rows.
template <class Rays, class Hits>
bool trace_tiles(const WideTree& tree, const Rays& rays, const Hits& hits, std::size_t count,
                 const BatchOptions& options) {
    return answer_in_tiles<Rayf, Hitf>(
        count, options, [&](std::size_t i) { return rays[i]; },
        [&](std::span<const Rayf> some, std::span<Hitf> places) {
            trace(tree, some, places.data());
        },
        [&](std::size_t i, const Hitf& hit) { put_hit(hits, i, hit); });
}

/// By way of an array, so that frusta take those rays that start at one point.
void trace_in_array(const WideTree& tree, const RayColumns& rays, const HitColumns& hits,
                    RayPiece<Rayf, Hitf>& piece) {
    for (std::size_t begin = 0; begin < rays.count; begin += RayOrder::kPiece) {
        const std::size_t size = std::min(RayOrder::kPiece, rays.count - begin);
        piece.rays.resize(size);
        piece.hits.resize(size);
        for (std::size_t i = 0; i < size; ++i) piece.rays[i] = rays[begin + i];
        trace(tree, piece.rays, piece.hits.data());
        for (std::size_t i = 0; i < size; ++i) put_hit(hits, begin + i, piece.hits[i]);
    }
}

/// Some rays in columns, on this thread.
void trace(const WideTree& tree, const RayColumns& rays, const HitColumns& hits,
           RayPiece<Rayf, Hitf>& piece) {
    if (!is_plain(tree)) {
        for (std::size_t i = 0; i < rays.count; ++i) put_hit(hits, i, hit_on_scaled(tree, rays[i]));
        return;
    }
    // Runs of groups that frusta may take, and of others, which are traced where they are.
    const auto end_of_group = [&](std::size_t begin) {
        return std::min(begin + kGroup, rays.count);
    };
    const auto start_together = [&](std::size_t begin) {
        const float *first = rays.origin[begin], *last = rays.origin[end_of_group(begin) - 1];
        return std::equal(first, first + 3, last);
    };
    for (std::size_t begin = 0, end = 0; begin < rays.count; begin = end) {
        const bool together = start_together(begin);
        do end = end_of_group(end);
        while (end < rays.count && start_together(end) == together);
        const RayColumns some = rays.part(begin, end - begin);
        const HitColumns places = hits.part(begin, end - begin);
        if (together) {
            trace_in_array(tree, some, places, piece);
        } else {
            ray_kernels(tree.instruction_set()).closest_hits_in_columns(tree.view(), some, places);
        }
    }
}

/// Whether each ray hits anything; ask(kernels, begin, size) asks kernels for some of them.
template <class Rays, class Ask>
void ask_any(const WideTree& tree, const Rays& rays, std::size_t count, std::span<bool> hits,
             const BatchOptions& options, const Ask& ask) {
    check_hit_places(count, hits.size());
    const RayKernels& kernels = ray_kernels(tree.instruction_set());
    for_each_piece(count, piece_of(count), options, [&](std::size_t begin, std::size_t end) {
        if (is_plain(tree)) return ask(kernels, begin, end - begin);
        for (std::size_t i = begin; i < end; ++i) hits[i] = any_hit(tree, rays[i]);
    });
}

}  // namespace

void closest_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<Hitf> hits,
                  const BatchOptions& options) {
    check_hit_places(rays.size(), hits.size());
    if (trace_tiles(tree, rays, hits.data(), rays.size(), options)) return;
    for_each_piece(rays.size(), piece_of(rays.size()), options,
                   [&](std::size_t begin, std::size_t end) {
                       trace(tree, rays.subspan(begin, end - begin), hits.data() + begin);
                   });
}

void closest_hits(const WideTree& tree, const RayColumns& rays, const HitColumns& hits,
                  const BatchOptions& options) {
    check_hit_places(rays.count, hits.count);
    if (is_plain(tree) && trace_tiles(tree, rays, hits, rays.count, options)) return;
    RayPieces<Rayf, Hitf> pieces;
    for_each_piece(rays.count, piece_of(rays.count), options,
                   [&](std::size_t begin, std::size_t end) {
                       const std::size_t size = end - begin;
                       trace(tree, rays.part(begin, size), hits.part(begin, size), pieces.local());
                   });
}

void any_hits(const WideTree& tree, std::span<const Rayf> rays, std::span<bool> hits,
              const BatchOptions& options) {
    const auto ask = [&](const RayKernels& kernels, std::size_t begin, std::size_t size) {
        kernels.any_hits(tree.view(), rays.data() + begin, hits.data() + begin, size);
    };
    ask_any(tree, rays, rays.size(), hits, options, ask);
}

void any_hits(const WideTree& tree, const RayColumns& rays, std::span<bool> hits,
              const BatchOptions& options) {
    const auto ask = [&](const RayKernels& kernels, std::size_t begin, std::size_t size) {
        kernels.any_hits_in_columns(tree.view(), rays.part(begin, size), hits.data() + begin);
    };
    ask_any(tree, rays, rays.count, hits, options, ask);
}

}  // namespace boxwood
