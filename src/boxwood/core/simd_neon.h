// SPDX-License-Identifier: Apache-2.0
// NEON of 64-bit ARM: 4 lanes, fused multiply-add. See core/simd.h for the vocabulary.
#pragma once

#include <arm_neon.h>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_compress.h"

namespace boxwood {

struct Neon {
    static constexpr int kWidth = 4;
    static constexpr bool kFastFused = true;
    using Float = float32x4_t;
    using Int = uint32x4_t;
    using Quad = Neon;

    static BOXWOOD_KERNEL Float load(const float* p) { return vld1q_f32(p); }
    static BOXWOOD_KERNEL Int load(const std::uint32_t* p) { return vld1q_u32(p); }
    static BOXWOOD_KERNEL Float load_unaligned(const float* p) { return vld1q_f32(p); }
    static BOXWOOD_KERNEL Int load_unaligned(const std::uint32_t* p) { return vld1q_u32(p); }
    static BOXWOOD_KERNEL void store(float* p, Float x) { vst1q_f32(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(float* p, Float x) { vst1q_f32(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(std::uint32_t* p, Int x) { vst1q_u32(p, x); }
    static BOXWOOD_KERNEL Float broadcast(float x) { return vdupq_n_f32(x); }
    static BOXWOOD_KERNEL Int broadcast_integer(std::uint32_t x) { return vdupq_n_u32(x); }

    // Those that prefer a number to NaN: vminq and vmaxq prefer NaN.
    static BOXWOOD_KERNEL Float min(Float a, Float b) { return vminnmq_f32(a, b); }
    static BOXWOOD_KERNEL Float max(Float a, Float b) { return vmaxnmq_f32(a, b); }
    static BOXWOOD_KERNEL Float abs(Float x) { return vabsq_f32(x); }
    static BOXWOOD_KERNEL Float copy_sign(Float size, Float sign) {
        return vbslq_f32(vdupq_n_u32(0x80000000u), sign, size);
    }
    /// In every lane.
    static BOXWOOD_KERNEL Float largest_of_three(Float x) {
        return max(max(vdupq_laneq_f32(x, 0), vdupq_laneq_f32(x, 1)), vdupq_laneq_f32(x, 2));
    }
    static BOXWOOD_KERNEL unsigned signs(Float x) {
        return bits(vcltzq_s32(vreinterpretq_s32_f32(x)));
    }
    static BOXWOOD_KERNEL Float sqrt(Float x) { return vsqrtq_f32(x); }
    static BOXWOOD_KERNEL Float multiply_add(Float a, Float b, Float c) { return fused(a, b, c); }
    static BOXWOOD_KERNEL Float fused(Float a, Float b, Float c) { return vfmaq_f32(c, a, b); }

    static BOXWOOD_KERNEL unsigned less(Float a, Float b) { return bits(vcltq_f32(a, b)); }
    static BOXWOOD_KERNEL unsigned less_equal(Float a, Float b) { return bits(vcleq_f32(a, b)); }
    static BOXWOOD_KERNEL unsigned equal(Float a, Float b) { return bits(vceqq_f32(a, b)); }
    static BOXWOOD_KERNEL unsigned equal(Int a, Int b) { return bits(vceqq_u32(a, b)); }

    static BOXWOOD_KERNEL Float compress(unsigned mask, Float x) {
        return permute(x, lanes_of(mask));
    }
    static BOXWOOD_KERNEL Int compress(unsigned mask, Int x) { return permute(x, lanes_of(mask)); }

    static constexpr int kOrderBits = 4;
    static BOXWOOD_KERNEL Int order(const std::uint32_t* packed, int octant) {
        const Int shifted = vshlq_u32(load(packed), vdupq_n_s32(-kOrderBits * octant));
        return vandq_u32(shifted, vdupq_n_u32(3));
    }
    static BOXWOOD_KERNEL Float permute(Float x, Int order) {
        return vreinterpretq_f32_u32(permute(vreinterpretq_u32_f32(x), order));
    }
    static BOXWOOD_KERNEL Int permute(Int x, Int order) {
        // Bytes 4 i to 4 i + 3 for lane i.
        const Int bytes = vmlaq_u32(vdupq_n_u32(0x03020100), order, vdupq_n_u32(0x04040404));
        return vreinterpretq_u32_u8(
            vqtbl1q_u8(vreinterpretq_u8_u32(x), vreinterpretq_u8_u32(bytes)));
    }

    static BOXWOOD_KERNEL Float as_float(Int x) { return vreinterpretq_f32_u32(x); }

    static BOXWOOD_KERNEL void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 4; ++i) {
            field[i] = vld1q_f32(p + 8 * i);
            field[i + 4] = vld1q_f32(p + 8 * i + 4);
        }
        transpose(field);
        transpose(field + 4);
    }
    static BOXWOOD_KERNEL void store_records(float* p, Float (&field)[8]) {
        transpose(field);
        transpose(field + 4);
        for (int i = 0; i < 4; ++i) {
            vst1q_f32(p + 8 * i, field[i]);
            vst1q_f32(p + 8 * i + 4, field[i + 4]);
        }
    }

    static BOXWOOD_KERNEL Float select(unsigned mask, Float a, Float b) {
        return vbslq_f32(vtstq_u32(vdupq_n_u32(mask), lane_bits()), a, b);
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, float* p, Float x) {
        store(p, select(mask, x, load(p)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, std::uint32_t* p, Int x) {
        store_unaligned(p, vbslq_u32(vtstq_u32(vdupq_n_u32(mask), lane_bits()), x, load(p)));
    }

    static BOXWOOD_KERNEL float greatest(Float x) { return vmaxnmvq_f32(x); }
    static BOXWOOD_KERNEL float least(unsigned mask, Float x) {
        return vminnmvq_f32(select(mask, x, broadcast(__builtin_inff())));
    }

private:
    static BOXWOOD_KERNEL void transpose(Float* row) {
        const auto pairs = [](Float x) { return vreinterpretq_f64_f32(x); };
        const auto a = pairs(vtrn1q_f32(row[0], row[1])), b = pairs(vtrn2q_f32(row[0], row[1]));
        const auto c = pairs(vtrn1q_f32(row[2], row[3])), d = pairs(vtrn2q_f32(row[2], row[3]));
        row[0] = vreinterpretq_f32_f64(vtrn1q_f64(a, c));
        row[1] = vreinterpretq_f32_f64(vtrn1q_f64(b, d));
        row[2] = vreinterpretq_f32_f64(vtrn2q_f64(a, c));
        row[3] = vreinterpretq_f32_f64(vtrn2q_f64(b, d));
    }
    static BOXWOOD_KERNEL Int lane_bits() { return Int{1, 2, 4, 8}; }
    static BOXWOOD_KERNEL unsigned bits(Int mask) {
        return vaddvq_u32(vandq_u32(mask, lane_bits()));
    }
    static BOXWOOD_KERNEL Int lanes_of(unsigned mask) {
        return vmovl_u16(vget_low_u16(vmovl_u8(vld1_u8(kCompressLanes.of[mask]))));
    }
};

}  // namespace boxwood
