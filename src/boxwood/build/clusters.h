// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxwood/core/float_bits.h"

namespace boxwood {

/// How far apart partners may be.
constexpr int kMostRadius = 32;

/// The nodes still to be merged, in the order of the curve, coordinate by coordinate for SIMD.
struct Clusters {
    std::array<std::vector<float>, 3> lo, hi;
    std::vector<std::uint32_t> name;
    std::size_t size = 0;

    /// With a margin, so that the last nodes have neighbours too: far away ones.
    explicit Clusters(std::size_t most) : name(most) {
        for (int k = 0; k < 3; ++k) {
            lo[k].resize(most + kMostRadius);
            hi[k].resize(most + kMostRadius);
        }
    }
    void set_size(std::size_t new_size) {
        constexpr float kFarAway = 1e9f;
        size = new_size;
        for (int k = 0; k < 3; ++k) {
            std::fill_n(lo[k].begin() + size, kMostRadius, kFarAway);
            std::fill_n(hi[k].begin() + size, kMostRadius, kFarAway);
        }
    }
    void copy(std::size_t to, const Clusters& from, std::size_t i) {
        for (int k = 0; k < 3; ++k) {
            lo[k][to] = from.lo[k][i];
            hi[k][to] = from.hi[k][i];
        }
        name[to] = from.name[i];
    }
    void set_union(std::size_t to, const Clusters& from, std::size_t i, std::size_t j) {
        for (int k = 0; k < 3; ++k) {
            lo[k][to] = std::min(from.lo[k][i], from.lo[k][j]);
            hi[k][to] = std::max(from.hi[k][i], from.hi[k][j]);
        }
    }
    /// Half of it.
    float area(std::size_t i) const {
        const float x = hi[0][i] - lo[0][i], y = hi[1][i] - lo[1][i], z = hi[2][i] - lo[2][i];
        return x * y + y * z + z * x;
    }
};

// The cost of a pair (i, i + d): the area of the union, a positive float, whose bits have the order
// of its values. The lowest bits are the pair's rank. Two pairs that share a node have different
// ranks, so there are no ties; without ties the cheapest pair of any neighbourhood merges. Where
// all areas are equal, (0, 1), (2, 3), ... rank first, and half of the nodes are gone in each
// round.
using PairCost = std::int32_t;
constexpr PairCost kRanks = 2 * kMostRadius;

/// Among the pairs of one distance d, those of (i, i + d), (i + d, i + 2d) differ in this bit.
constexpr bool parity(std::size_t i, int distance) {
    return (i & static_cast<std::size_t>(distance & -distance)) != 0;
}
inline constexpr auto kRank = [] {
    std::array<std::array<PairCost, kMostRadius>, kRanks> rank = {};
    for (int i = 0; i < kRanks; ++i) {
        for (int d = 1; d <= kMostRadius; ++d) rank[i][d - 1] = 2 * (d - 1) + parity(i, d);
    }
    return rank;
}();
/// From i to its partner.
inline std::int32_t offset_of_partner(std::size_t i, PairCost cost) {
    const int rank = cost % kRanks, distance = rank / 2 + 1;
    return parity(i, distance) == (rank % 2 != 0) ? distance : -distance;
}

/// The costs of the pairs (i, i + 1) to (i, i + radius).
inline void compute_costs(const Clusters& clusters, std::size_t i, int radius, PairCost* costs) {
    constexpr float kLeast = 0x1p-120f;
    const float *lx = &clusters.lo[0][i], *ly = &clusters.lo[1][i], *lz = &clusters.lo[2][i];
    const float *hx = &clusters.hi[0][i], *hy = &clusters.hi[1][i], *hz = &clusters.hi[2][i];
    const float lx0 = *lx, ly0 = *ly, lz0 = *lz, hx0 = *hx, hy0 = *hy, hz0 = *hz;
    const PairCost* rank = kRank[i % kRanks].data();
    for (int d = 1; d <= radius; ++d) {
        const float x = std::max(hx[d], hx0) - std::min(lx[d], lx0);
        const float y = std::max(hy[d], hy0) - std::min(ly[d], ly0);
        const float z = std::max(hz[d], hz0) - std::min(lz[d], lz0);
        const float area = x * y + y * z + z * x + kLeast;
        costs[d - 1] = (static_cast<PairCost>(bits_of(area)) & -kRanks) | rank[d - 1];
    }
}

}  // namespace boxwood
