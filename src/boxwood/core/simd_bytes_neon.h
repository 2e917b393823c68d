// SPDX-License-Identifier: Apache-2.0
// NEON of 64-bit ARM: 16 characters. See core/simd_bytes.h for the vocabulary.
#pragma once

#include <arm_neon.h>

#include "boxwood/core/simd_bytes.h"

namespace boxwood {

struct NeonBytes : SixteenInWords {
    static constexpr int kWidth = 16;
    using Vector = uint8x16_t;

    static BOXWOOD_KERNEL Vector load(const char* p) {
        return vld1q_u8(reinterpret_cast<const std::uint8_t*>(p));
    }
    static BOXWOOD_KERNEL std::uint64_t less(Vector x, char c) {
        return bits(vcltq_u8(x, vdupq_n_u8(static_cast<std::uint8_t>(c))));
    }
    static BOXWOOD_KERNEL std::uint64_t equal(Vector x, char c) {
        return bits(vceqq_u8(x, vdupq_n_u8(static_cast<std::uint8_t>(c))));
    }
    static BOXWOOD_KERNEL std::uint64_t digits(Vector x) {
        return less(veorq_u8(x, vdupq_n_u8('0')), 10);
    }

private:
    /// One bit of each character, and the sum of each half's.
    static BOXWOOD_KERNEL std::uint64_t bits(uint8x16_t mask) {
        const uint8x8_t bit = vcreate_u8(0x8040201008040201);
        const uint8x16_t chosen = vandq_u8(mask, vcombine_u8(bit, bit));
        return vaddv_u8(vget_low_u8(chosen)) |
               static_cast<std::uint64_t>(vaddv_u8(vget_high_u8(chosen))) << 8;
    }
};

}  // namespace boxwood
