// SPDX-License-Identifier: Apache-2.0
// AVX-512 (F, BW, DQ, VL): 16 lanes. See core/simd.h for the vocabulary.
#pragma once

#include <immintrin.h>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_sse4.h"

namespace boxwood {

struct Avx512 {
    static constexpr int kWidth = 16;
    static constexpr bool kFastFused = true;
    using Float = __m512;
    using Quad = Sse4;
    using Int = __m512i;

    static BOXWOOD_KERNEL Float load(const float* p) { return _mm512_load_ps(p); }
    static BOXWOOD_KERNEL Int load(const std::uint32_t* p) { return _mm512_load_si512(p); }
    static BOXWOOD_KERNEL Float load_unaligned(const float* p) { return _mm512_loadu_ps(p); }
    static BOXWOOD_KERNEL Int load_unaligned(const std::uint32_t* p) {
        return _mm512_loadu_si512(p);
    }
    static BOXWOOD_KERNEL void store(float* p, Float x) { _mm512_store_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(float* p, Float x) { _mm512_storeu_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(std::uint32_t* p, Int x) {
        _mm512_storeu_si512(p, x);
    }
    static BOXWOOD_KERNEL Float broadcast(float x) { return _mm512_set1_ps(x); }
    static BOXWOOD_KERNEL Int broadcast_integer(std::uint32_t x) {
        return _mm512_set1_epi32(static_cast<int>(x));
    }

    static BOXWOOD_KERNEL Float min(Float a, Float b) { return _mm512_min_ps(a, b); }
    static BOXWOOD_KERNEL Float max(Float a, Float b) { return _mm512_max_ps(a, b); }
    static BOXWOOD_KERNEL Float sqrt(Float x) { return _mm512_sqrt_ps(x); }
    static BOXWOOD_KERNEL Float multiply_add(Float a, Float b, Float c) { return fused(a, b, c); }
    static BOXWOOD_KERNEL Float fused(Float a, Float b, Float c) {
        return _mm512_fmadd_ps(a, b, c);
    }

    static BOXWOOD_KERNEL unsigned less(Float a, Float b) {
        return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
    }
    static BOXWOOD_KERNEL unsigned less_equal(Float a, Float b) {
        return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
    }
    static BOXWOOD_KERNEL unsigned equal(Float a, Float b) {
        return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ);
    }
    static BOXWOOD_KERNEL unsigned equal(Int a, Int b) { return _mm512_cmpeq_epi32_mask(a, b); }

    static BOXWOOD_KERNEL Float compress(unsigned mask, Float x) {
        return _mm512_maskz_compress_ps(static_cast<__mmask16>(mask), x);
    }
    static BOXWOOD_KERNEL Int compress(unsigned mask, Int x) {
        return _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), x);
    }

    /// Four bits an octant; the permutation below reads the lowest four.
    static constexpr int kOrderBits = 4;
    static BOXWOOD_KERNEL Int order(const std::uint32_t* packed, int octant) {
        return _mm512_srl_epi32(load(packed), _mm_cvtsi32_si128(kOrderBits * octant));
    }
    static BOXWOOD_KERNEL Float permute(Float x, Int order) {
        return _mm512_permutexvar_ps(order, x);
    }
    static BOXWOOD_KERNEL Int permute(Int x, Int order) {
        return _mm512_permutexvar_epi32(order, x);
    }

    static BOXWOOD_KERNEL Float as_float(Int x) { return _mm512_castsi512_ps(x); }

    static BOXWOOD_KERNEL void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 8; ++i)
            field[i] = _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_loadu_ps(p + 8 * i)),
                                          _mm256_loadu_ps(p + 64 + 8 * i), 1);
        transpose(field);
    }
    static BOXWOOD_KERNEL void store_records(float* p, Float (&field)[8]) {
        transpose(field);
        for (int i = 0; i < 8; ++i) {
            _mm256_storeu_ps(p + 8 * i, _mm512_castps512_ps256(field[i]));
            _mm256_storeu_ps(p + 64 + 8 * i, _mm512_extractf32x8_ps(field[i], 1));
        }
    }

    static BOXWOOD_KERNEL Float select(unsigned mask, Float a, Float b) {
        return _mm512_mask_blend_ps(static_cast<__mmask16>(mask), b, a);
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, float* p, Float x) {
        _mm512_mask_store_ps(p, static_cast<__mmask16>(mask), x);
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, std::uint32_t* p, Int x) {
        _mm512_mask_store_epi32(p, static_cast<__mmask16>(mask), x);
    }

    static BOXWOOD_KERNEL float greatest(Float x) { return _mm512_reduce_max_ps(x); }
    static BOXWOOD_KERNEL float least(unsigned mask, Float x) {
        return _mm512_mask_reduce_min_ps(static_cast<__mmask16>(mask), x);
    }

private:
    /// Two squares of 8 x 8, side by side, about their diagonals.
    static BOXWOOD_KERNEL void transpose(Float (&row)[8]) {
        Float pair[8], quad[8];
        for (int i = 0; i < 8; i += 2) {
            pair[i] = _mm512_unpacklo_ps(row[i], row[i + 1]);
            pair[i + 1] = _mm512_unpackhi_ps(row[i], row[i + 1]);
        }
        for (int i = 0; i < 8; i += 4) {
            quad[i] = _mm512_shuffle_ps(pair[i], pair[i + 2], _MM_SHUFFLE(1, 0, 1, 0));
            quad[i + 1] = _mm512_shuffle_ps(pair[i], pair[i + 2], _MM_SHUFFLE(3, 2, 3, 2));
            quad[i + 2] = _mm512_shuffle_ps(pair[i + 1], pair[i + 3], _MM_SHUFFLE(1, 0, 1, 0));
            quad[i + 3] = _mm512_shuffle_ps(pair[i + 1], pair[i + 3], _MM_SHUFFLE(3, 2, 3, 2));
        }
        const Int low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        const Int high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        for (int i = 0; i < 4; ++i) {
            const __m512d a = _mm512_castps_pd(quad[i]), b = _mm512_castps_pd(quad[i + 4]);
            row[i] = _mm512_castpd_ps(_mm512_permutex2var_pd(a, low, b));
            row[i + 4] = _mm512_castpd_ps(_mm512_permutex2var_pd(a, high, b));
        }
    }
};

}  // namespace boxwood
