// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boxwood/core/batch.h"
#include "boxwood/core/vec.h"

namespace boxwood {

constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();

/// The order in which the points follow a Morton curve through their bounds; points that aren't
/// finite come anywhere. O(n), all cores. Precondition: fewer than 2^32 of them.
std::vector<std::uint32_t> order_along_curve(std::span<const Vec3d> points);

/// Calls visit(i, before) once for each point i, on all cores, such that the point visited before
/// on the same thread is nearby, so that what it needed is in the caches still; kNoPoint for the
/// first. So many points are put in order at a time, which bounds the memory: 20 bytes for each.
/// Throws what BatchOptions says.
template <class Visit>
void for_each_along_curve(std::span<const Vec3d> points, const BatchOptions& options,
                          const Visit& visit) {
    ProgressReport report(points.size(), options.progress);
    const BatchOptions unreported = {.cancellation = options.cancellation,
                                     .on_this_thread = options.on_this_thread};
    constexpr std::size_t kOrderedAtATime = std::size_t{1} << 17, kPiece = 1024;
    for (std::size_t first = 0; first < points.size(); first += kOrderedAtATime) {
        const auto part = points.subspan(first, std::min(kOrderedAtATime, points.size() - first));
        const std::vector<std::uint32_t> order = order_along_curve(part);
        for_each_piece(order.size(), kPiece, unreported, [&](std::size_t begin, std::size_t end) {
            std::size_t before = kNoPoint;
            for (std::size_t k = begin; k < end; ++k) {
                visit(first + order[k], before);
                before = first + order[k];
            }
            report.add(end - begin);
        });
    }
    if (!points.empty()) report.finish();
}

}  // namespace boxwood
