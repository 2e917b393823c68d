// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "boxwood/core/simd.h"

namespace boxwood {

/// The vocabulary of core/simd.h behind plain pointers, so that one test, compiled for any machine,
/// can try every instruction set. Arrays hold `width` numbers; those of functions with a "quad" in
/// their names hold four.
struct Vocabulary {
    using Unary = void (*)(const float* a, float* out);
    using Binary = void (*)(const float* a, const float* b, float* out);
    using Ternary = void (*)(const float* a, const float* b, const float* c, float* out);
    using Comparison = unsigned (*)(const float* a, const float* b);

    int width;
    Unary copy, copy_unaligned;
    void (*copy_integers)(const std::uint32_t* a, std::uint32_t* out);
    void (*copy_integers_unaligned)(const std::uint32_t* a, std::uint32_t* out);
    void (*broadcast)(float a, float* out);
    Binary add, subtract, multiply, divide;
    Unary negate;
    Binary min, max;
    Unary sqrt;
    Unary quad_abs;
    Binary quad_copy_sign;
    unsigned (*quad_signs)(const float* a);
    Ternary multiply_add, fused;
    Comparison less, less_equal, equal;
    void (*compress)(unsigned mask, const float* a, float* out);
    void (*compress_integers)(unsigned mask, const std::uint32_t* a, std::uint32_t* out);
    void (*permute)(const float* a, const std::uint32_t* packed, int octant, float* out);
    void (*permute_integers)(const std::uint32_t* a, const std::uint32_t* packed, int octant,
                             std::uint32_t* out);
    void (*as_float)(const std::uint32_t* a, float* out);
    void (*load_records)(const float* records, float* fields);
    void (*store_records)(const float* fields, float* records);
    void (*select)(unsigned mask, const float* a, const float* b, float* out);
    void (*store_masked)(unsigned mask, float* out, const float* a);
    void (*store_masked_integers)(unsigned mask, std::uint32_t* out, const std::uint32_t* a);
    void (*broadcast_integer)(std::uint32_t a, std::uint32_t* out);
    unsigned (*equal_integers)(const std::uint32_t* a, const std::uint32_t* b);
    float (*greatest)(const float* a);
    float (*least)(unsigned mask, const float* a);
};

template <class S>
constexpr Vocabulary vocabulary_of() {
    using Float = typename S::Float;
    using Q = typename S::Quad;
    constexpr int N = S::kWidth;
    return {
        .width = N,
        .copy = [](const float* a, float* out) { S::store(out, S::load(a)); },
        .copy_unaligned = [](const float* a,
                             float* out) { S::store_unaligned(out, S::load_unaligned(a)); },
        .copy_integers = [](const std::uint32_t* a,
                            std::uint32_t* out) { S::store_unaligned(out, S::load(a)); },
        .copy_integers_unaligned =
            [](const std::uint32_t* a, std::uint32_t* out) {
                S::store_unaligned(out, S::load_unaligned(a));
            },
        .broadcast = [](float a, float* out) { S::store(out, S::broadcast(a)); },
        .add = [](const float* a, const float* b,
                  float* out) { S::store(out, S::load(a) + S::load(b)); },
        .subtract = [](const float* a, const float* b,
                       float* out) { S::store(out, S::load(a) - S::load(b)); },
        .multiply = [](const float* a, const float* b,
                       float* out) { S::store(out, S::load(a) * S::load(b)); },
        .divide = [](const float* a, const float* b,
                     float* out) { S::store(out, S::load(a) / S::load(b)); },
        .negate = [](const float* a, float* out) { S::store(out, -S::load(a)); },
        .min = [](const float* a, const float* b,
                  float* out) { S::store(out, S::min(S::load(a), S::load(b))); },
        .max = [](const float* a, const float* b,
                  float* out) { S::store(out, S::max(S::load(a), S::load(b))); },
        .sqrt = [](const float* a, float* out) { S::store(out, S::sqrt(S::load(a))); },
        .quad_abs = [](const float* a, float* out) { Q::store(out, Q::abs(Q::load(a))); },
        .quad_copy_sign = [](const float* a, const float* b,
                             float* out) { Q::store(out, Q::copy_sign(Q::load(a), Q::load(b))); },
        .quad_signs = [](const float* a) { return Q::signs(Q::load(a)); },
        .multiply_add =
            [](const float* a, const float* b, const float* c, float* out) {
                S::store(out, S::multiply_add(S::load(a), S::load(b), S::load(c)));
            },
        .fused = [](const float* a, const float* b, const float* c,
                    float* out) { S::store(out, S::fused(S::load(a), S::load(b), S::load(c))); },
        .less = [](const float* a, const float* b) { return S::less(S::load(a), S::load(b)); },
        .less_equal = [](const float* a,
                         const float* b) { return S::less_equal(S::load(a), S::load(b)); },
        .equal = [](const float* a, const float* b) { return S::equal(S::load(a), S::load(b)); },
        .compress = [](unsigned mask, const float* a,
                       float* out) { S::store(out, S::compress(mask, S::load(a))); },
        .compress_integers =
            [](unsigned mask, const std::uint32_t* a, std::uint32_t* out) {
                S::store_unaligned(out, S::compress(mask, S::load(a)));
            },
        .permute =
            [](const float* a, const std::uint32_t* packed, int octant, float* out) {
                S::store(out, S::permute(S::load(a), S::order(packed, octant)));
            },
        .permute_integers =
            [](const std::uint32_t* a, const std::uint32_t* packed, int octant,
               std::uint32_t* out) {
                S::store_unaligned(out, S::permute(S::load(a), S::order(packed, octant)));
            },
        .as_float = [](const std::uint32_t* a,
                       float* out) { S::store(out, S::as_float(S::load(a))); },
        .load_records =
            [](const float* records, float* fields) {
                Float field[8];
                S::load_records(records, field);
                for (int i = 0; i < 8; ++i) S::store(fields + i * N, field[i]);
            },
        .store_records =
            [](const float* fields, float* records) {
                Float field[8];
                for (int i = 0; i < 8; ++i) field[i] = S::load(fields + i * N);
                S::store_records(records, field);
            },
        .select = [](unsigned mask, const float* a, const float* b,
                     float* out) { S::store(out, S::select(mask, S::load(a), S::load(b))); },
        .store_masked = [](unsigned mask, float* out,
                           const float* a) { S::store_masked(mask, out, S::load(a)); },
        .store_masked_integers =
            [](unsigned mask, std::uint32_t* out, const std::uint32_t* a) {
                S::store_masked(mask, out, S::load(a));
            },
        .broadcast_integer =
            [](std::uint32_t a, std::uint32_t* out) {
                S::store_unaligned(out, S::broadcast_integer(a));
            },
        .equal_integers = [](const std::uint32_t* a,
                             const std::uint32_t* b) { return S::equal(S::load(a), S::load(b)); },
        .greatest = [](const float* a) { return S::greatest(S::load(a)); },
        .least = [](unsigned mask, const float* a) { return S::least(mask, S::load(a)); },
    };
}

// One of these a source file, compiled for that instruction set alone.
const Vocabulary& scalar_vocabulary();
const Vocabulary& sse4_vocabulary();
const Vocabulary& avx2_vocabulary();
const Vocabulary& avx512_vocabulary();
const Vocabulary& neon_vocabulary();
const Vocabulary& wasm_vocabulary();

}  // namespace boxwood
