// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/weld.h"

#include <tbb/parallel_sort.h>

#include <array>
#include <cstring>
#include <limits>

#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;

struct Position {
    std::array<std::uint64_t, 3> bits;
    std::uint32_t vertex;
};

/// Any total order will do, and one of bits, unlike <, has a place for NaN.
Position position_of(const Vec3d& point, std::size_t vertex) {
    Position result{{}, static_cast<std::uint32_t>(vertex)};
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = point[static_cast<int>(k)] + 0.0;  // -0.0 becomes 0.0
        std::memcpy(&result.bits[k], &x, sizeof x);
    }
    return result;
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const Vec3d> vertices) {
    std::vector<Position> positions(vertices.size());
    parallel_for(vertices.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) positions[i] = position_of(vertices[i], i);
    });
    tbb::parallel_sort(positions,
                       [](const Position& a, const Position& b) { return a.bits < b.bits; });

    std::vector<std::uint32_t> names(vertices.size());
    std::uint32_t name = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (i > 0 && positions[i].bits != positions[i - 1].bits) ++name;
        names[positions[i].vertex] = name;
    }
    return names;
}

std::vector<std::uint32_t> first_at_position(std::span<const Vec3d> vertices) {
    return first_at_position(vertices, weld(vertices));
}

std::vector<std::uint32_t> first_at_position(std::span<const Vec3d> vertices,
                                             std::span<const std::uint32_t> names) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> first_of_name(vertices.size(), kNone), firsts(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto self = static_cast<std::uint32_t>(i);
        std::uint32_t& first = first_of_name[names[i]];
        if (first == kNone) first = self;
        firsts[i] = vertices[i].hasNaN() ? self : first;
    }
    return firsts;
}

}  // namespace boxwood
