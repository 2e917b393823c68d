// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace boxwood {

/// For each mask of eight lanes: which lanes are in it, from the lowest on. It stands in for the
/// instruction that moves these lanes together, where a machine has none.
struct CompressLanes {
    std::uint8_t of[256][8] = {};

    constexpr CompressLanes() {
        for (int mask = 0; mask < 256; ++mask) {
            int end = 0;
            for (std::uint8_t lane = 0; lane < 8; ++lane) {
                if (mask >> lane & 1) of[mask][end++] = lane;
            }
        }
    }
};

alignas(64) inline constexpr CompressLanes kCompressLanes;

}  // namespace boxwood
