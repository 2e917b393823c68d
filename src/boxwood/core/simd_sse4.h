// SPDX-License-Identifier: Apache-2.0
// SSE4.1: 4 lanes, no fused multiply-add. See core/simd.h for the vocabulary.
#pragma once

#include <smmintrin.h>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_compress.h"
#include "boxwood/core/simd_fused.h"

namespace boxwood {

struct Sse4 {
    static constexpr int kWidth = 4;
    static constexpr bool kFastFused = false;
    using Float = __m128;
    using Int = __m128i;
    using Quad = Sse4;

    static BOXWOOD_KERNEL Float load(const float* p) { return _mm_load_ps(p); }
    static BOXWOOD_KERNEL Int load(const std::uint32_t* p) {
        return _mm_load_si128(reinterpret_cast<const __m128i*>(p));
    }
    static BOXWOOD_KERNEL Float load_unaligned(const float* p) { return _mm_loadu_ps(p); }
    static BOXWOOD_KERNEL Int load_unaligned(const std::uint32_t* p) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
    }
    static BOXWOOD_KERNEL void store(float* p, Float x) { _mm_store_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(float* p, Float x) { _mm_storeu_ps(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(std::uint32_t* p, Int x) {
        _mm_storeu_si128(reinterpret_cast<__m128i*>(p), x);
    }
    static BOXWOOD_KERNEL Float broadcast(float x) { return _mm_set1_ps(x); }
    static BOXWOOD_KERNEL Int broadcast_integer(std::uint32_t x) {
        return _mm_set1_epi32(static_cast<int>(x));
    }

    static BOXWOOD_KERNEL Float min(Float a, Float b) { return _mm_min_ps(a, b); }
    static BOXWOOD_KERNEL Float max(Float a, Float b) { return _mm_max_ps(a, b); }
    static BOXWOOD_KERNEL Float abs(Float x) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), x); }
    static BOXWOOD_KERNEL Float copy_sign(Float size, Float sign) {
        return _mm_or_ps(size, _mm_and_ps(_mm_set1_ps(-0.0f), sign));
    }
    /// In every lane.
    static BOXWOOD_KERNEL Float largest_of_three(Float x) {
        const Float y = _mm_shuffle_ps(x, x, _MM_SHUFFLE(1, 1, 1, 1));
        const Float z = _mm_shuffle_ps(x, x, _MM_SHUFFLE(2, 2, 2, 2));
        const Float xxxx = _mm_shuffle_ps(x, x, _MM_SHUFFLE(0, 0, 0, 0));
        return max(max(xxxx, y), z);
    }
    static BOXWOOD_KERNEL unsigned signs(Float x) { return bits(x); }
    static BOXWOOD_KERNEL Float sqrt(Float x) { return _mm_sqrt_ps(x); }
    static BOXWOOD_KERNEL Float multiply_add(Float a, Float b, Float c) { return a * b + c; }
    static BOXWOOD_KERNEL Float fused(Float a, Float b, Float c) {
        const __m128d low = fused_to_odd(_mm_cvtps_pd(a), _mm_cvtps_pd(b), _mm_cvtps_pd(c));
        const __m128d high = fused_to_odd(upper(a), upper(b), upper(c));
        return _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
    }

    static BOXWOOD_KERNEL unsigned less(Float a, Float b) { return bits(_mm_cmplt_ps(a, b)); }
    static BOXWOOD_KERNEL unsigned less_equal(Float a, Float b) { return bits(_mm_cmple_ps(a, b)); }
    static BOXWOOD_KERNEL unsigned equal(Float a, Float b) { return bits(_mm_cmpeq_ps(a, b)); }
    static BOXWOOD_KERNEL unsigned equal(Int a, Int b) {
        return bits(_mm_castsi128_ps(_mm_cmpeq_epi32(a, b)));
    }

    static BOXWOOD_KERNEL Float compress(unsigned mask, Float x) {
        return permute(x, lanes_of(mask));
    }
    static BOXWOOD_KERNEL Int compress(unsigned mask, Int x) { return permute(x, lanes_of(mask)); }

    static constexpr int kOrderBits = 4;
    static BOXWOOD_KERNEL Int order(const std::uint32_t* packed, int octant) {
        const Int shifted = _mm_srl_epi32(load(packed), _mm_cvtsi32_si128(kOrderBits * octant));
        return _mm_and_si128(shifted, _mm_set1_epi32(3));
    }
    static BOXWOOD_KERNEL Float permute(Float x, Int order) {
        return _mm_castsi128_ps(permute(_mm_castps_si128(x), order));
    }
    static BOXWOOD_KERNEL Int permute(Int x, Int order) {
        // Bytes 4 i to 4 i + 3 for lane i.
        const Int first = _mm_shuffle_epi8(
            order, _mm_setr_epi8(0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12));
        return _mm_shuffle_epi8(x,
                                _mm_add_epi8(_mm_slli_epi32(first, 2), _mm_set1_epi32(0x03020100)));
    }

    static BOXWOOD_KERNEL Float as_float(Int x) { return _mm_castsi128_ps(x); }

    static BOXWOOD_KERNEL void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 4; ++i) {
            field[i] = _mm_loadu_ps(p + 8 * i);
            field[i + 4] = _mm_loadu_ps(p + 8 * i + 4);
        }
        transpose(field);
    }
    static BOXWOOD_KERNEL void store_records(float* p, Float (&field)[8]) {
        transpose(field);
        for (int i = 0; i < 4; ++i) {
            _mm_storeu_ps(p + 8 * i, field[i]);
            _mm_storeu_ps(p + 8 * i + 4, field[i + 4]);
        }
    }

    static BOXWOOD_KERNEL Float select(unsigned mask, Float a, Float b) {
        return _mm_blendv_ps(b, a, _mm_castsi128_ps(mask_of(mask)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, float* p, Float x) {
        store(p, select(mask, x, load(p)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, std::uint32_t* p, Int x) {
        store_unaligned(p, _mm_blendv_epi8(load_unaligned(p), x, mask_of(mask)));
    }

    static BOXWOOD_KERNEL float greatest(Float x) { return -least((1u << kWidth) - 1, -x); }
    static BOXWOOD_KERNEL float least(unsigned mask, Float x) {
        alignas(16) float lane[kWidth];
        store(lane, x);
        float least = lane[__builtin_ctz(mask)];
        for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
            const float other = lane[__builtin_ctz(mask)];
            if (other < least) least = other;
        }
        return least;
    }

private:
    /// Two squares of 4 x 4.
    static BOXWOOD_KERNEL void transpose(Float (&row)[8]) {
        _MM_TRANSPOSE4_PS(row[0], row[1], row[2], row[3]);
        _MM_TRANSPOSE4_PS(row[4], row[5], row[6], row[7]);
    }
    static BOXWOOD_KERNEL Int mask_of(unsigned mask) {
        const Int lane = _mm_setr_epi32(1, 2, 4, 8);
        return _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(static_cast<int>(mask)), lane), lane);
    }
    static BOXWOOD_KERNEL unsigned bits(__m128 mask) {
        return static_cast<unsigned>(_mm_movemask_ps(mask));
    }
    static BOXWOOD_KERNEL Int lanes_of(unsigned mask) {
        return _mm_cvtepu8_epi32(_mm_loadu_si32(kCompressLanes.of[mask]));
    }
    static BOXWOOD_KERNEL __m128d upper(Float x) { return _mm_cvtps_pd(_mm_movehl_ps(x, x)); }
};

}  // namespace boxwood
