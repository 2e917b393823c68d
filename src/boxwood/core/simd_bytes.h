// SPDX-License-Identifier: Apache-2.0
// What reading text asks of an instruction set, in headers of their own beside those of
// core/simd.h, core/simd_bytes_NAME.h, each with one struct of static functions:
//
//   Vector                        kWidth characters
//   load(p)                       from anywhere
//   less(x, c), equal(x, c)       masks: bit i is character i; unsigned, c below 128
//   digits(x)                     a mask: those from '0' to '9'
//   Sixteen                       16 characters
//   load_sixteen(p)               from anywhere
//   last_halves(a, b)             the last eight of a and the last eight of b
//   both(a, b)                    bits that are set in both
//   select(mask, a, b)            bits of a where those of the mask are set, else of b
//   numbers(x)                    of 16 digits from 0 to 9 (not '0' to '9') two numbers of eight
//                                 each, the first of them in the low half
//
// Characters are in the order of little-endian machines.
#pragma once

#include <cstdint>
#include <cstring>

#include "boxwood/core/simd.h"

namespace boxwood {

/// Sixteen characters in two words, where a machine has nothing better.
struct SixteenInWords {
    struct Sixteen {
        std::uint64_t first, last;
    };

    static BOXWOOD_KERNEL Sixteen load_sixteen(const void* p) {
        Sixteen result;
        std::memcpy(&result, p, sizeof(result));
        return result;
    }
    static BOXWOOD_KERNEL Sixteen last_halves(Sixteen a, Sixteen b) { return {a.last, b.last}; }
    static BOXWOOD_KERNEL Sixteen both(Sixteen a, Sixteen b) {
        return {a.first & b.first, a.last & b.last};
    }
    static BOXWOOD_KERNEL Sixteen select(Sixteen mask, Sixteen a, Sixteen b) {
        return {(a.first & mask.first) | (b.first & ~mask.first),
                (a.last & mask.last) | (b.last & ~mask.last)};
    }
    static BOXWOOD_KERNEL std::uint64_t numbers(Sixteen x) {
        return number(x.first) | number(x.last) << 32;
    }

private:
    /// Pairs of digits, then fours, then all eight.
    static BOXWOOD_KERNEL std::uint64_t number(std::uint64_t digits) {
        const std::uint64_t pairs = digits * 10 + (digits >> 8);
        return ((pairs & 0x000000ff000000ff) * 0x000f424000000064 +
                (pairs >> 16 & 0x000000ff000000ff) * 0x0000271000000001) >>
               32;
    }
};

}  // namespace boxwood
