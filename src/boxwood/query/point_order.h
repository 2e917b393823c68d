// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/core/vec.h"

namespace boxwood {

constexpr std::size_t kNoPoint = std::numeric_limits<std::size_t>::max();

/// The order in which the points follow a Morton curve through their bounds; points that aren't
/// finite come anywhere. O(n log n). Precondition: fewer than 2^32 of them.
std::vector<std::uint32_t> order_along_curve(std::span<const Vec3d> points);

/// Calls visit(i, before) once for each point i, on all cores, such that the point visited before
/// on the same thread is nearby, so that what it needed is in the caches still; kNoPoint for the
/// first. The points are taken a few thousand at a time, which bounds the memory.
template <class Visit>
void for_each_along_curve(std::span<const Vec3d> points, const Visit& visit) {
    constexpr std::size_t kPiece = std::size_t{1} << 14;
    const std::size_t pieces = (points.size() + kPiece - 1) / kPiece;
    parallel_for(pieces, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t piece = first; piece < last; ++piece) {
            const std::size_t begin = piece * kPiece;
            const auto part = points.subspan(begin, std::min(kPiece, points.size() - begin));
            std::size_t before = kNoPoint;
            for (const std::uint32_t i : order_along_curve(part)) {
                visit(begin + i, before);
                before = begin + i;
            }
        }
    });
}

}  // namespace boxwood
