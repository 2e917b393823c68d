// SPDX-License-Identifier: Apache-2.0
// A multiplication and an addition that are rounded once, on every instruction set that this
// machine has, and what says so where the machine can't.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <string>

#include "core/float_fma.h"
#include "core/simd_fixture.h"

namespace boxwood {
namespace {

class SimdFused : public Simd {};

TEST_P(SimdFused, multiply_add_rounds_once_or_twice) {
    Floats out;
    for (int round = 0; round < 20000; ++round) {
        const Floats a = numbers.lanes(), b = numbers.lanes(), c = numbers.lanes();
        simd.multiply_add(a, b, c, out);
        for (int i = 0; i < width; ++i)
            ASSERT_TRUE(are_same(out[i], a[i] * b[i] + c[i]) ||
                        are_same(out[i], float_fma(a[i], b[i], c[i])))
                << text(a[i]) << " * " << text(b[i]) << " + " << text(c[i]);
    }
}

/// Draws factors and summands of all sorts, many of whose results are hard to round.
struct Triple {
    float a, b, c;
};
Triple draw_triple(Numbers& numbers) {
    Triple t = {numbers.any(), numbers.any(), numbers.any()};
    const auto below = [&](std::uint32_t end) { return static_cast<int>(numbers.below(end)); };
    switch (numbers.below(8)) {
        case 0:
            t = {numbers.nasty(), numbers.nasty(), numbers.nasty()};
            break;
        case 1:  // all alike in size: ties
            t = {numbers.with_exponent(-2, 2), numbers.with_exponent(-2, 2),
                 numbers.with_exponent(-30, 30)};
            break;
        case 2: {  // the product and the summand cancel but for a few digits
            t.a = numbers.with_exponent(-20, 20);
            t.b = numbers.with_exponent(-20, 20);
            t.c = float_of(bits_of(-(t.a * t.b)) + numbers.below(5) - 2);
            break;
        }
        case 3: {  // subnormal, or just not
            const int e = below(140);
            t = {std::ldexp(numbers.mantissa(), -e),
                 std::ldexp(numbers.mantissa(), e - 150 + below(40)),
                 std::ldexp(numbers.mantissa(), -150 + below(30))};
            break;
        }
        case 4: {  // about the largest float
            const int e = below(128);
            t = {std::ldexp(numbers.mantissa(), e),
                 std::ldexp(numbers.mantissa(), 126 - e + below(3)),
                 std::ldexp(numbers.mantissa(), 100 + below(28))};
            break;
        }
        case 5: {  // one far below the other
            const int e = below(60);
            t.c = std::ldexp(std::copysign(1.0f, numbers.mantissa()), below(40));
            if (numbers.below(2)) t.c = numbers.with_exponent(0, 40);
            t.a = numbers.with_exponent(-e, 0);
            t.b = numbers.with_exponent(-80, 0);
            break;
        }
        case 6: {  // the summand and half a unit in its last place, but for a digit or less of
                   // double
            const float step = static_cast<float>(below(12)) * 0x1p-16f;
            t.c = numbers.mantissa();
            t.a = std::ldexp(1 + step, -12);
            t.b = std::ldexp(numbers.below(2) ? 1 - step : 1 + FLT_EPSILON, -12 - below(2));
            if (numbers.below(2)) t.a = -t.a;
            break;
        }
        default:
            break;
    }
    return t;
}

TEST_P(SimdFused, fused_rounds_once) {
    Floats a, b, c, out;
    for (int round = 0; round < 3'000'000 / width; ++round) {
        for (int i = 0; i < width; ++i) {
            const Triple triple = draw_triple(numbers);
            a[i] = triple.a;
            b[i] = triple.b;
            c[i] = triple.c;
        }
        simd.fused(a, b, c, out);
        for (int i = 0; i < width; ++i)
            ASSERT_TRUE(are_same(out[i], float_fma(a[i], b[i], c[i])))
                << text(a[i]) << " * " << text(b[i]) << " + " << text(c[i]) << " = "
                << text(float_fma(a[i], b[i], c[i])) << ", not " << text(out[i]);
    }
}

TEST_P(SimdFused, fused_rounds_once_whatever_is_nasty) {
    Floats out;
    for (const float x : nasty_floats()) {
        for (const float y : nasty_floats()) {
            const Floats a = numbers.lanes([&] { return x; }), b = numbers.lanes([&] { return y; });
            for (const float z : nasty_floats()) {
                simd.fused(a, b, numbers.lanes([&] { return z; }), out);
                ASSERT_TRUE(all_are(out, width, [&](int) { return float_fma(x, y, z); }))
                    << text(x) << " * " << text(y) << " + " << text(z);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, SimdFused, all_instruction_sets(),
                         [](const auto& info) { return std::string(info.param.name); });

#if !defined(__wasm__)
TEST(FloatFma, by_integers_equals_that_of_the_machine) {
    Numbers numbers;
    for (int i = 0; i < 3'000'000; ++i) {
        const auto [a, b, c] = draw_triple(numbers);
        ASSERT_TRUE(are_same(float_fma_by_integers(a, b, c), std::fma(a, b, c)))
            << text(a) << " * " << text(b) << " + " << text(c);
    }
}
#endif

}  // namespace
}  // namespace boxwood
