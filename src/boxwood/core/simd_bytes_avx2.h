// SPDX-License-Identifier: Apache-2.0
// AVX2: 32 characters. See core/simd_bytes.h for the vocabulary.
#pragma once

#include <immintrin.h>

#include "boxwood/core/simd_bytes_sse4.h"

namespace boxwood {

struct Avx2Bytes : Sse4Bytes {
    static constexpr int kWidth = 32;
    using Vector = __m256i;

    static BOXWOOD_KERNEL Vector load(const char* p) {
        return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
    }
    static BOXWOOD_KERNEL std::uint64_t less(Vector x, char c) {
        const __m256i most = _mm256_set1_epi8(static_cast<char>(c - 1));
        return bits(_mm256_cmpeq_epi8(_mm256_min_epu8(x, most), x));
    }
    static BOXWOOD_KERNEL std::uint64_t equal(Vector x, char c) {
        return bits(_mm256_cmpeq_epi8(x, _mm256_set1_epi8(c)));
    }
    static BOXWOOD_KERNEL std::uint64_t digits(Vector x) {
        return less(_mm256_xor_si256(x, _mm256_set1_epi8('0')), 10);
    }

private:
    static BOXWOOD_KERNEL std::uint64_t bits(__m256i mask) {
        return static_cast<std::uint32_t>(_mm256_movemask_epi8(mask));
    }
};

}  // namespace boxwood
