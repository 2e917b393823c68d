// SPDX-License-Identifier: Apache-2.0
// WebAssembly's 128-bit SIMD: 4 lanes, no fused multiply-add. See core/simd.h for the vocabulary.
#pragma once

#include <wasm_simd128.h>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_compress.h"
#include "boxwood/core/simd_fused.h"

namespace boxwood {

struct Wasm {
    static constexpr int kWidth = 4;
    static constexpr bool kFastFused = false;
    /// Its operators are those of floats; v128_t has those of integers.
    using Float = float __attribute__((vector_size(16)));
    using Int = v128_t;
    using Quad = Wasm;

    static BOXWOOD_KERNEL Float load(const float* p) { return floats(wasm_v128_load(p)); }
    static BOXWOOD_KERNEL Int load(const std::uint32_t* p) { return wasm_v128_load(p); }
    static BOXWOOD_KERNEL Float load_unaligned(const float* p) { return load(p); }
    static BOXWOOD_KERNEL Int load_unaligned(const std::uint32_t* p) { return load(p); }
    static BOXWOOD_KERNEL void store(float* p, Float x) { wasm_v128_store(p, bytes(x)); }
    static BOXWOOD_KERNEL void store_unaligned(float* p, Float x) { store(p, x); }
    static BOXWOOD_KERNEL void store_unaligned(std::uint32_t* p, Int x) { wasm_v128_store(p, x); }
    static BOXWOOD_KERNEL Float broadcast(float x) { return floats(wasm_f32x4_splat(x)); }
    static BOXWOOD_KERNEL Int broadcast_integer(std::uint32_t x) { return wasm_i32x4_splat(x); }

    // a < b ? a : b and a > b ? a : b, one instruction of most machines; wasm_f32x4_min and
    // wasm_f32x4_max prefer NaN and take several.
    static BOXWOOD_KERNEL Float min(Float a, Float b) {
        return floats(wasm_f32x4_pmin(bytes(b), bytes(a)));
    }
    static BOXWOOD_KERNEL Float max(Float a, Float b) {
        return floats(wasm_f32x4_pmax(bytes(b), bytes(a)));
    }
    static BOXWOOD_KERNEL Float abs(Float x) { return floats(wasm_f32x4_abs(bytes(x))); }
    static BOXWOOD_KERNEL Float copy_sign(Float size, Float sign) {
        const Int sign_bits = wasm_v128_and(bytes(sign), wasm_i32x4_splat(INT32_MIN));
        return floats(wasm_v128_or(bytes(size), sign_bits));
    }
    /// In every lane.
    static BOXWOOD_KERNEL Float largest_of_three(Float x) {
        return max(max(wasm_i32x4_shuffle(x, x, 0, 0, 0, 0), wasm_i32x4_shuffle(x, x, 1, 1, 1, 1)),
                   wasm_i32x4_shuffle(x, x, 2, 2, 2, 2));
    }
    static BOXWOOD_KERNEL unsigned signs(Float x) { return bits(bytes(x)); }
    static BOXWOOD_KERNEL Float sqrt(Float x) { return floats(wasm_f32x4_sqrt(bytes(x))); }
    static BOXWOOD_KERNEL Float multiply_add(Float a, Float b, Float c) { return a * b + c; }
    static BOXWOOD_KERNEL Float fused(Float a, Float b, Float c) {
        const Int low = to_float(fused_to_odd(lower(a), lower(b), lower(c)));
        const Int high = to_float(fused_to_odd(upper(a), upper(b), upper(c)));
        return floats(wasm_i64x2_shuffle(low, high, 0, 2));
    }

    static BOXWOOD_KERNEL unsigned less(Float a, Float b) {
        return bits(wasm_f32x4_lt(bytes(a), bytes(b)));
    }
    static BOXWOOD_KERNEL unsigned less_equal(Float a, Float b) {
        return bits(wasm_f32x4_le(bytes(a), bytes(b)));
    }
    static BOXWOOD_KERNEL unsigned equal(Float a, Float b) {
        return bits(wasm_f32x4_eq(bytes(a), bytes(b)));
    }
    static BOXWOOD_KERNEL unsigned equal(Int a, Int b) { return bits(wasm_i32x4_eq(a, b)); }

    static BOXWOOD_KERNEL Float compress(unsigned mask, Float x) {
        return permute(x, lanes_of(mask));
    }
    static BOXWOOD_KERNEL Int compress(unsigned mask, Int x) { return permute(x, lanes_of(mask)); }

    static constexpr int kOrderBits = 4;
    static BOXWOOD_KERNEL Int order(const std::uint32_t* packed, int octant) {
        const Int shifted = wasm_u32x4_shr(load(packed), kOrderBits * octant);
        return wasm_v128_and(shifted, wasm_i32x4_splat(3));
    }
    static BOXWOOD_KERNEL Float permute(Float x, Int order) {
        return floats(permute(bytes(x), order));
    }
    static BOXWOOD_KERNEL Int permute(Int x, Int order) {
        // Bytes 4 i to 4 i + 3 for lane i.
        const Int first =
            wasm_i8x16_shuffle(order, order, 0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12);
        return wasm_i8x16_swizzle(
            x, wasm_v128_or(wasm_i32x4_shl(first, 2), wasm_i32x4_splat(0x03020100)));
    }

    static BOXWOOD_KERNEL Float as_float(Int x) { return floats(x); }

    static BOXWOOD_KERNEL void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 4; ++i) {
            field[i] = load(p + 8 * i);
            field[i + 4] = load(p + 8 * i + 4);
        }
        transpose(field);
        transpose(field + 4);
    }
    static BOXWOOD_KERNEL void store_records(float* p, Float (&field)[8]) {
        transpose(field);
        transpose(field + 4);
        for (int i = 0; i < 4; ++i) {
            store(p + 8 * i, field[i]);
            store(p + 8 * i + 4, field[i + 4]);
        }
    }

    static BOXWOOD_KERNEL Float select(unsigned mask, Float a, Float b) {
        return floats(wasm_v128_bitselect(bytes(a), bytes(b), mask_of(mask)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, float* p, Float x) {
        store(p, select(mask, x, load(p)));
    }
    static BOXWOOD_KERNEL void store_masked(unsigned mask, std::uint32_t* p, Int x) {
        store_unaligned(p, wasm_v128_bitselect(x, load(p), mask_of(mask)));
    }

    static BOXWOOD_KERNEL float greatest(Float x) { return -least((1u << kWidth) - 1, -x); }
    static BOXWOOD_KERNEL float least(unsigned mask, Float x) {
        const Int all = bytes(select(mask, x, broadcast(__builtin_inff())));
        const Int pair = wasm_f32x4_pmin(all, wasm_i32x4_shuffle(all, all, 2, 3, 0, 1));
        const Int least = wasm_f32x4_pmin(pair, wasm_i32x4_shuffle(pair, pair, 1, 0, 3, 2));
        return wasm_f32x4_extract_lane(least, 0);
    }

private:
    static BOXWOOD_KERNEL Float floats(v128_t x) { return reinterpret_cast<Float>(x); }
    static BOXWOOD_KERNEL v128_t bytes(Float x) { return reinterpret_cast<v128_t>(x); }

    static BOXWOOD_KERNEL void transpose(Float* row) {
        const Int r0 = bytes(row[0]), r1 = bytes(row[1]), r2 = bytes(row[2]), r3 = bytes(row[3]);
        const Int a = wasm_i32x4_shuffle(r0, r1, 0, 4, 1, 5),
                  b = wasm_i32x4_shuffle(r0, r1, 2, 6, 3, 7);
        const Int c = wasm_i32x4_shuffle(r2, r3, 0, 4, 1, 5),
                  d = wasm_i32x4_shuffle(r2, r3, 2, 6, 3, 7);
        row[0] = floats(wasm_i64x2_shuffle(a, c, 0, 2));
        row[1] = floats(wasm_i64x2_shuffle(a, c, 1, 3));
        row[2] = floats(wasm_i64x2_shuffle(b, d, 0, 2));
        row[3] = floats(wasm_i64x2_shuffle(b, d, 1, 3));
    }
    static BOXWOOD_KERNEL Int mask_of(unsigned mask) {
        const Int lane = wasm_i32x4_const(1, 2, 4, 8);
        return wasm_i32x4_eq(wasm_v128_and(wasm_i32x4_splat(static_cast<int>(mask)), lane), lane);
    }
    static BOXWOOD_KERNEL unsigned bits(v128_t mask) { return wasm_i32x4_bitmask(mask); }
    static BOXWOOD_KERNEL Int lanes_of(unsigned mask) {
        const Int lanes = wasm_v128_load32_zero(kCompressLanes.of[mask]);
        return wasm_u32x4_extend_low_u16x8(wasm_u16x8_extend_low_u8x16(lanes));
    }
    static BOXWOOD_KERNEL Double2 lower(Float x) {
        return reinterpret_cast<Double2>(wasm_f64x2_promote_low_f32x4(bytes(x)));
    }
    static BOXWOOD_KERNEL Double2 upper(Float x) {
        const Int upper = wasm_i64x2_shuffle(bytes(x), bytes(x), 1, 1);
        return reinterpret_cast<Double2>(wasm_f64x2_promote_low_f32x4(upper));
    }
    static BOXWOOD_KERNEL Int to_float(Double2 x) {
        return wasm_f32x4_demote_f64x2_zero(reinterpret_cast<v128_t>(x));
    }
};

}  // namespace boxwood
