// SPDX-License-Identifier: Apache-2.0
// Sixteen characters that end with a number become a whole number by sums of pairs, of fours and of
// eights (Lemire, "Number parsing at a gigabyte per second", 2021). A point is taken out of them by
// loading them twice, the second time from one place further ahead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "boxwood/core/simd.h"
#include "boxwood/mesh/text_kernels/text_kernels.h"

namespace boxwood {

/// Loaded from the n-th on, the last n of sixteen bytes are set; all, if n is more.
struct LastBytes {
    std::uint8_t bytes[16 + kTextWindow] = {};

    explicit constexpr LastBytes(std::uint8_t value) {
        for (std::size_t i = 16; i < std::size(bytes); ++i) bytes[i] = value;
    }
};

inline constexpr LastBytes kLastBytes(0xff), kLastDigits(0x0f);

/// The last of sixteen digits, so many of them, as numbers from 0 to 9, the others 0.
template <class Bytes>
BOXWOOD_KERNEL typename Bytes::Sixteen last_digits(typename Bytes::Sixteen text, unsigned count) {
    return Bytes::both(text, Bytes::load_sixteen(kLastDigits.bytes + count));
}

/// Those as a whole number.
template <class Bytes>
BOXWOOD_KERNEL std::uint64_t whole_number(typename Bytes::Sixteen text, unsigned count) {
    const std::uint64_t halves = Bytes::numbers(last_digits<Bytes>(text, count));
    return (halves & 0xffffffff) * 100000000 + (halves >> 32);
}

/// The characters in front of a place without a point that stands before the last of them, the
/// decimals.
template <class Bytes>
BOXWOOD_KERNEL typename Bytes::Sixteen without_point(const char* end, unsigned decimals) {
    return Bytes::select(Bytes::load_sixteen(kLastBytes.bytes + decimals),
                         Bytes::load_sixteen(end - 16), Bytes::load_sixteen(end - 17));
}

}  // namespace boxwood
