// SPDX-License-Identifier: Apache-2.0
// Source: Morton, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing",
// IBM, 1966.
#include "boxwood/query/point_order.h"

#include <algorithm>

#include "boxwood/core/box.h"
#include "boxwood/core/radix_sort.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 8192;

/// Two zeros before each of the lowest ten bits.
std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

Box3d bounds_of(std::span<const Vec3d> points) {
    return parallel_reduce(
        points.size(), kPiece, Box3d{},
        [&](std::size_t begin, std::size_t end) {
            Box3d bounds;
            for (const Vec3d& point : points.subspan(begin, end - begin)) {
                if (point.allFinite()) bounds.extend(point);
            }
            return bounds;
        },
        [](const Box3d& a, const Box3d& b) { return merged(a, b); });
}

}  // namespace

std::vector<std::uint32_t> order_along_curve(std::span<const Vec3d> points) {
    const Box3d bounds = bounds_of(points);
    constexpr double kCells = 1024;
    const double extent = bounds.is_empty() ? 0 : bounds.extent().maxCoeff();
    const double cells = extent > 0 && extent < 1e300 ? kCells / extent : 0;
    const auto cell = [&](const Vec3d& point, int k) {
        const double place = cells * (point[k] - bounds.lo[k]);
        return place > 0 ? static_cast<std::uint32_t>(std::min(place, kCells - 1)) : 0;
    };
    // The code above, the point below.
    std::vector<std::uint64_t> keys(points.size()), sorted(points.size());
    parallel_for(points.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t code = spread(cell(points[i], 0)) |
                                       spread(cell(points[i], 1)) << 1 |
                                       spread(cell(points[i], 2)) << 2;
            keys[i] = std::uint64_t{code} << 32 | i;
        }
    });
    radix_sort(keys, sorted, 32, 30);
    std::vector<std::uint32_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(sorted[i]);
    return order;
}

}  // namespace boxwood
