// SPDX-License-Identifier: Apache-2.0
// Eight characters in a word, as any machine can. See core/simd_bytes.h for the vocabulary.
#pragma once

#include "boxwood/core/simd_bytes.h"

namespace boxwood {

struct ScalarBytes : SixteenInWords {
    static constexpr int kWidth = 8;
    using Vector = std::uint64_t;

    static BOXWOOD_KERNEL Vector load(const char* p) {
        std::uint64_t result;
        std::memcpy(&result, p, sizeof(result));
        return result;
    }
    static BOXWOOD_KERNEL std::uint64_t less(Vector x, char c) {
        const auto limit = static_cast<std::uint64_t>(c);
        // No byte carries into the next: the sums are at most 0x7f + 0x80.
        return high_bits(~(((x & ~kHigh) + (0x80 - limit) * kOnes) | x));
    }
    static BOXWOOD_KERNEL std::uint64_t equal(Vector x, char c) {
        return less(x ^ static_cast<std::uint64_t>(c) * kOnes, 1);
    }
    static BOXWOOD_KERNEL std::uint64_t digits(Vector x) {
        // Those whose high half is 3 become their low half, others are at least 16.
        return less(x ^ std::uint64_t{'0'} * kOnes, 10);
    }

private:
    static constexpr std::uint64_t kOnes = 0x0101010101010101, kHigh = 0x8080808080808080;

    /// The highest bits of the bytes, side by side.
    static BOXWOOD_KERNEL std::uint64_t high_bits(std::uint64_t x) {
        return ((x & kHigh) >> 7) * 0x0102040810204080 >> 56;
    }
};

}  // namespace boxwood
