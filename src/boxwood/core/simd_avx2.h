// SPDX-License-Identifier: Apache-2.0
// AVX2 with FMA and BMI2: 8 lanes. See core/simd.h for the vocabulary.
#pragma once

#include <immintrin.h>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_compress.h"
#include "boxwood/core/simd_sse4.h"

namespace boxwood {

struct Avx2 {
    static constexpr int kWidth = 8;
    static constexpr bool kFastFused = true;
    using Float = __m256;
    using Quad = Sse4;
    using Int = __m256i;

    static BOXWOOD_KERNEL Float load(const float* p) { return _mm256_load_ps(p); }
    static BOXWOOD_KERNEL Int load(const std::uint32_t* p) {
        return _mm256_load_si256(reinterpret_cast<const __m256i*>(p));
    }
    static BOXWOOD_KERNEL Float load_unaligned(const float* p) { return _mm256_loadu_ps(p); }
    static BOXWOOD_KERNEL Int load_unaligned(const std::uint32_t* p) {
        return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
    }
    static BOXWOOD_KERNEL void store(float* p, Float x) { _mm256_store_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(float* p, Float x) { _mm256_storeu_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(std::uint32_t* p, Int x) {
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), x);
    }
    static BOXWOOD_KERNEL Float broadcast(float x) { return _mm256_set1_ps(x); }
    static BOXWOOD_KERNEL Int broadcast_integer(std::uint32_t x) {
        return _mm256_set1_epi32(static_cast<int>(x));
    }

    static BOXWOOD_KERNEL Float min(Float a, Float b) { return _mm256_min_ps(a, b); }
    static BOXWOOD_KERNEL Float max(Float a, Float b) { return _mm256_max_ps(a, b); }
    static BOXWOOD_KERNEL Float sqrt(Float x) { return _mm256_sqrt_ps(x); }
    static BOXWOOD_KERNEL Float multiply_add(Float a, Float b, Float c) { return fused(a, b, c); }
    static BOXWOOD_KERNEL Float fused(Float a, Float b, Float c) {
        return _mm256_fmadd_ps(a, b, c);
    }

    static BOXWOOD_KERNEL unsigned less(Float a, Float b) {
        return bits(_mm256_cmp_ps(a, b, _CMP_LT_OQ));
    }
    static BOXWOOD_KERNEL unsigned less_equal(Float a, Float b) {
        return bits(_mm256_cmp_ps(a, b, _CMP_LE_OQ));
    }
    static BOXWOOD_KERNEL unsigned equal(Float a, Float b) {
        return bits(_mm256_cmp_ps(a, b, _CMP_EQ_OQ));
    }
    static BOXWOOD_KERNEL unsigned equal(Int a, Int b) {
        return bits(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)));
    }

    static BOXWOOD_KERNEL Float compress(unsigned mask, Float x) {
        return permute(x, lanes_of(mask));
    }
    static BOXWOOD_KERNEL Int compress(unsigned mask, Int x) { return permute(x, lanes_of(mask)); }

    /// Four bits an octant; the permutation below reads the lowest three.
    static constexpr int kOrderBits = 4;
    static BOXWOOD_KERNEL Int order(const std::uint32_t* packed, int octant) {
        return _mm256_srl_epi32(load(packed), _mm_cvtsi32_si128(kOrderBits * octant));
    }
    static BOXWOOD_KERNEL Float permute(Float x, Int order) {
        return _mm256_permutevar8x32_ps(x, order);
    }
    static BOXWOOD_KERNEL Int permute(Int x, Int order) {
        return _mm256_permutevar8x32_epi32(x, order);
    }

    static BOXWOOD_KERNEL Float as_float(Int x) { return _mm256_castsi256_ps(x); }

    static BOXWOOD_KERNEL void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 8; ++i) field[i] = _mm256_loadu_ps(p + 8 * i);
        transpose(field);
    }
    static BOXWOOD_KERNEL void store_records(float* p, Float (&field)[8]) {
        transpose(field);
        for (int i = 0; i < 8; ++i) _mm256_storeu_ps(p + 8 * i, field[i]);
    }

    static BOXWOOD_KERNEL Float select(unsigned mask, Float a, Float b) {
        return _mm256_blendv_ps(b, a, _mm256_castsi256_ps(mask_of(mask)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, float* p, Float x) {
        store(p, select(mask, x, load(p)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, std::uint32_t* p, Int x) {
        store_unaligned(p, _mm256_blendv_epi8(load_unaligned(p), x, mask_of(mask)));
    }

    static BOXWOOD_KERNEL float greatest(Float x) { return -least((1u << kWidth) - 1, -x); }
    static BOXWOOD_KERNEL float least(unsigned mask, Float x) {
        alignas(32) float lane[kWidth];
        store(lane, x);
        float least = lane[__builtin_ctz(mask)];
        for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
            const float other = lane[__builtin_ctz(mask)];
            if (other < least) least = other;
        }
        return least;
    }

private:
    static BOXWOOD_KERNEL void transpose(Float (&row)[8]) {
        Float pair[8], quad[8];
        for (int i = 0; i < 8; i += 2) {
            pair[i] = _mm256_unpacklo_ps(row[i], row[i + 1]);
            pair[i + 1] = _mm256_unpackhi_ps(row[i], row[i + 1]);
        }
        for (int i = 0; i < 8; i += 4) {
            quad[i] = _mm256_shuffle_ps(pair[i], pair[i + 2], _MM_SHUFFLE(1, 0, 1, 0));
            quad[i + 1] = _mm256_shuffle_ps(pair[i], pair[i + 2], _MM_SHUFFLE(3, 2, 3, 2));
            quad[i + 2] = _mm256_shuffle_ps(pair[i + 1], pair[i + 3], _MM_SHUFFLE(1, 0, 1, 0));
            quad[i + 3] = _mm256_shuffle_ps(pair[i + 1], pair[i + 3], _MM_SHUFFLE(3, 2, 3, 2));
        }
        for (int i = 0; i < 4; ++i) {
            row[i] = _mm256_permute2f128_ps(quad[i], quad[i + 4], 0x20);
            row[i + 4] = _mm256_permute2f128_ps(quad[i], quad[i + 4], 0x31);
        }
    }
    static BOXWOOD_KERNEL Int mask_of(unsigned mask) {
        const Int lane = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
        return _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(static_cast<int>(mask)), lane),
                                  lane);
    }
    static BOXWOOD_KERNEL unsigned bits(__m256 mask) {
        return static_cast<unsigned>(_mm256_movemask_ps(mask));
    }
    static BOXWOOD_KERNEL Int lanes_of(unsigned mask) {
        return _mm256_cvtepu8_epi32(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kCompressLanes.of[mask])));
    }
};

}  // namespace boxwood
