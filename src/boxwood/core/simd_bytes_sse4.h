// SPDX-License-Identifier: Apache-2.0
// SSE4.1: 16 characters. See core/simd_bytes.h for the vocabulary.
#pragma once

#include <smmintrin.h>

#include "boxwood/core/simd_bytes.h"

namespace boxwood {

struct Sse4Bytes {
    static constexpr int kWidth = 16;
    using Vector = __m128i;
    using Sixteen = __m128i;

    static BOXWOOD_KERNEL Vector load(const char* p) { return load_sixteen(p); }
    static BOXWOOD_KERNEL std::uint64_t less(Vector x, char c) {
        const __m128i most = _mm_set1_epi8(static_cast<char>(c - 1));
        return bits(_mm_cmpeq_epi8(_mm_min_epu8(x, most), x));
    }
    static BOXWOOD_KERNEL std::uint64_t equal(Vector x, char c) {
        return bits(_mm_cmpeq_epi8(x, _mm_set1_epi8(c)));
    }
    static BOXWOOD_KERNEL std::uint64_t digits(Vector x) {
        return less(_mm_xor_si128(x, _mm_set1_epi8('0')), 10);
    }

    static BOXWOOD_KERNEL Sixteen load_sixteen(const void* p) {
        return _mm_loadu_si128(static_cast<const __m128i*>(p));
    }
    static BOXWOOD_KERNEL Sixteen last_halves(Sixteen a, Sixteen b) {
        return _mm_unpackhi_epi64(a, b);
    }
    static BOXWOOD_KERNEL Sixteen both(Sixteen a, Sixteen b) { return _mm_and_si128(a, b); }
    static BOXWOOD_KERNEL Sixteen select(Sixteen mask, Sixteen a, Sixteen b) {
        // Blending by bytes takes three steps on many machines.
        return _mm_xor_si128(b, _mm_and_si128(_mm_xor_si128(a, b), mask));
    }
    static BOXWOOD_KERNEL std::uint64_t numbers(Sixteen x) {
        const __m128i pairs = _mm_maddubs_epi16(x, _mm_set1_epi16(0x010a));
        const __m128i fours = _mm_madd_epi16(pairs, _mm_set1_epi32(0x00010064));
        const __m128i packed = _mm_packus_epi32(fours, fours);
        const __m128i eights = _mm_madd_epi16(packed, _mm_set1_epi32(0x00012710));
        return static_cast<std::uint64_t>(_mm_cvtsi128_si64(eights));
    }

private:
    static BOXWOOD_KERNEL std::uint64_t bits(__m128i mask) {
        return static_cast<std::uint32_t>(_mm_movemask_epi8(mask));
    }
};

}  // namespace boxwood
