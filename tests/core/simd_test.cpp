// SPDX-License-Identifier: Apache-2.0
// Every word of core/simd.h against plain loops, on every instruction set that this machine has.
#include "boxwood/core/simd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "boxwood/core/float_bits.h"
#include "core/float_fma.h"
#include "core/vocabulary.h"

namespace boxwood {

/// How tests that it is a parameter of are listed.
static void PrintTo(const Named<InstructionSet>& set, std::ostream* out) { *out << set.name; }

namespace {

constexpr int kMostLanes = 16;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Room for the lanes of any vector.
template <class T>
struct alignas(64) Lanes {
    T lane[kMostLanes] = {};

    T& operator[](int i) { return lane[i]; }
    const T& operator[](int i) const { return lane[i]; }
    operator T*() { return lane; }
    operator const T*() const { return lane; }
};
using Floats = Lanes<float>;
using Integers = Lanes<std::uint32_t>;

/// NaNs are alike, zeros are not.
bool are_same(float a, float b) { return std::isnan(a) ? std::isnan(b) : bits_of(a) == bits_of(b); }

std::string text(float x) {
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "%a", static_cast<double>(x));
    return buffer;
}

/// Numbers that something may go wrong with.
const std::vector<float>& nasty_floats() {
    static const std::vector<float> kFloats = [] {
        std::vector<float> floats;
        for (const float x : {0.0f,
                              1.0f,
                              1 + FLT_EPSILON,
                              1 - FLT_EPSILON / 2,
                              1.5f,
                              3.0f,
                              0x1p-24f,
                              0x1.fffffep-25f,
                              0x1p24f,
                              0x1.000002p24f,
                              FLT_MAX,
                              FLT_MIN,
                              0x1.fffffcp-127f,
                              0x1p-149f,
                              0x1.8p-148f,
                              0x1p-75f,
                              0x1.8p-75f,
                              0x1p-126f,
                              0x1p64f,
                              0x1.fffffep63f,
                              kInfinity,
                              kNaN}) {
            floats.push_back(x);
            floats.push_back(-x);
        }
        return floats;
    }();
    return kFloats;
}

class Numbers {
public:
    std::uint32_t integer() { return static_cast<std::uint32_t>(generator_()); }
    std::uint32_t below(std::uint32_t end) { return integer() % end; }
    float any() { return float_of(integer()); }
    float nasty() {
        const auto& floats = nasty_floats();
        return floats[below(static_cast<std::uint32_t>(floats.size()))];
    }
    /// 1 <= |x| < 2, with all digits or few.
    float mantissa() {
        std::uint32_t digits = integer();
        if (below(2) == 0) digits = 1u << below(32) | 1u << below(32) | 1u << below(32);
        return float_of((digits & 0x807fffffu) | 0x3f800000u);
    }
    float with_exponent(int lowest, int highest) {
        return std::ldexp(
            mantissa(),
            lowest + static_cast<int>(below(static_cast<std::uint32_t>(highest - lowest + 1))));
    }
    template <class Draw>
    Floats lanes(const Draw& draw) {
        Floats result;
        for (float& x : result.lane) x = draw();
        return result;
    }
    /// Not NaN.
    Floats lanes() {
        return lanes(
            [&] { return below(4) == 0 ? std::fmax(nasty(), -1e30f) : with_exponent(-4, 4); });
    }
    Integers integer_lanes() {
        Integers result;
        for (std::uint32_t& x : result.lane) x = integer();
        return result;
    }

private:
    std::mt19937_64 generator_{1};
};

const Vocabulary& vocabulary(InstructionSet set) {
    switch (set) {
#if defined(__x86_64__)
        case InstructionSet::sse4:
            return sse4_vocabulary();
        case InstructionSet::avx2:
            return avx2_vocabulary();
        case InstructionSet::avx512:
            return avx512_vocabulary();
#elif defined(__aarch64__)
        case InstructionSet::neon:
            return neon_vocabulary();
#elif defined(__wasm__)
        case InstructionSet::wasm:
            return wasm_vocabulary();
#endif
        default:
            return scalar_vocabulary();
    }
}

class Simd : public testing::TestWithParam<Named<InstructionSet>> {
protected:
    void SetUp() override {
        if (!is_supported(GetParam().value)) GTEST_SKIP() << "this machine hasn't got it";
    }

    /// Whether out is expected(i) in each of the lanes.
    template <class Expected>
    testing::AssertionResult all_are(const float* out, int count, const Expected& expected) {
        for (int i = 0; i < count; ++i) {
            if (!are_same(out[i], expected(i)))
                return testing::AssertionFailure() << "lane " << i << ": " << text(out[i])
                                                   << " instead of " << text(expected(i));
        }
        return testing::AssertionSuccess();
    }
    template <class Expected>
    testing::AssertionResult all_are(const std::uint32_t* out, int count,
                                     const Expected& expected) {
        for (int i = 0; i < count; ++i) {
            if (out[i] != expected(i))
                return testing::AssertionFailure()
                       << "lane " << i << ": " << out[i] << " instead of " << expected(i);
        }
        return testing::AssertionSuccess();
    }

    template <class Expected>
    void expect_binary(Vocabulary::Binary f, const Expected& expected) {
        Floats out;
        for (const float x : nasty_floats()) {
            for (int round = 0; round < 100; ++round) {
                const Floats a = numbers.lanes([&] { return x; });
                const Floats b = numbers.lanes(
                    [&] { return numbers.below(2) ? numbers.nasty() : numbers.any(); });
                f(a, b, out);
                ASSERT_TRUE(all_are(out, width, [&](int i) { return expected(a[i], b[i]); }))
                    << text(x);
            }
        }
    }

    template <class Expected>
    void expect_comparison(Vocabulary::Comparison f, const Expected& expected) {
        for (const float x : nasty_floats()) {
            for (int round = 0; round < 100; ++round) {
                const Floats a =
                    numbers.lanes([&] { return numbers.below(2) ? x : numbers.nasty(); });
                const Floats b =
                    numbers.lanes([&] { return numbers.below(2) ? x : numbers.nasty(); });
                unsigned mask = 0;
                for (int i = 0; i < width; ++i) mask |= unsigned{expected(a[i], b[i])} << i;
                ASSERT_EQ(f(a, b), mask) << text(x);
            }
        }
    }

    std::vector<unsigned> masks() const {
        std::vector<unsigned> all(std::size_t{1} << width);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }

    const Vocabulary& simd = vocabulary(GetParam().value);
    const int width = simd.width;
    Numbers numbers;
};

TEST_P(Simd, has_as_many_lanes_as_it_says) { EXPECT_EQ(width, lanes(GetParam().value)); }

TEST_P(Simd, copies_every_bit) {
    const Integers a = numbers.integer_lanes();
    Floats floats, out;
    for (int i = 0; i < width; ++i) floats[i] = float_of(a[i] & ~0x40000000u);
    simd.copy(floats, out);
    EXPECT_EQ(std::memcmp(out.lane, floats.lane, sizeof(float) * width), 0);
    Integers integers;
    simd.copy_integers(a, integers);
    EXPECT_TRUE(all_are(integers, width, [&](int i) { return a[i]; }));
    simd.as_float(a, out);
    EXPECT_EQ(std::memcmp(out.lane, a.lane, sizeof(float) * width), 0);
}

TEST_P(Simd, copies_from_and_to_any_place_and_touches_nothing_beside_it) {
    for (int from = 0; from < 4; ++from) {
        for (int to = 1; to < 4; ++to) {
            alignas(64) float a[32], out[32];
            alignas(64) std::uint32_t b[32], integers[32];
            for (int i = 0; i < 32; ++i) {
                a[i] = static_cast<float>(i);
                b[i] = numbers.integer();
                out[i] = -1;
                integers[i] = 7;
            }
            simd.copy_unaligned(a + from, out + to);
            simd.copy_integers_unaligned(b + from, integers + to);
            for (int i = 0; i < 32; ++i) {
                const bool inside = i >= to && i < to + width;
                EXPECT_EQ(out[i], inside ? a[from + i - to] : -1);
                EXPECT_EQ(integers[i], inside ? b[from + i - to] : 7);
            }
        }
    }
}

TEST_P(Simd, broadcasts) {
    Floats out;
    for (const float x : nasty_floats()) {
        simd.broadcast(x, out);
        EXPECT_TRUE(all_are(out, width, [&](int) { return x; }));
    }
}

TEST_P(Simd, adds_subtracts_multiplies_and_divides_as_floats_do) {
    expect_binary(simd.add, [](float a, float b) { return a + b; });
    expect_binary(simd.subtract, [](float a, float b) { return a - b; });
    expect_binary(simd.multiply, [](float a, float b) { return a * b; });
    expect_binary(simd.divide, [](float a, float b) { return a / b; });
    Floats out;
    for (const float x : nasty_floats()) {
        simd.negate(numbers.lanes([&] { return x; }), out);
        EXPECT_TRUE(all_are(out, width, [&](int) { return -x; }));
    }
}

TEST_P(Simd, min_and_max_give_the_second_where_the_first_is_nan) {
    Floats min, max;
    for (const float x : nasty_floats()) {
        for (const float y : nasty_floats()) {
            const Floats a = numbers.lanes([&] { return x; }), b = numbers.lanes([&] { return y; });
            simd.min(a, b, min);
            simd.max(a, b, max);
            for (int i = 0; i < width; ++i) {
                if (std::isnan(x)) {
                    ASSERT_TRUE(are_same(min[i], y) && are_same(max[i], y)) << text(y);
                } else if (std::isnan(y)) {
                    ASSERT_TRUE(are_same(min[i], x) || std::isnan(min[i])) << text(x);
                    ASSERT_TRUE(are_same(max[i], x) || std::isnan(max[i])) << text(x);
                } else {
                    ASSERT_EQ(min[i], std::min(x, y)) << text(x) << " " << text(y);
                    ASSERT_EQ(max[i], std::max(x, y)) << text(x) << " " << text(y);
                }
            }
        }
    }
}

TEST_P(Simd, quads_know_signs) {
    Floats out;
    for (const float x : nasty_floats()) {
        for (const float y : nasty_floats()) {
            const Floats a = numbers.lanes([&] { return x; });
            simd.quad_abs(a, out);
            ASSERT_TRUE(all_are(out, 4, [&](int) { return std::fabs(x); })) << text(x);
            const Floats size = numbers.lanes([&] { return std::fabs(x); });
            simd.quad_copy_sign(size, numbers.lanes([&] { return y; }), out);
            ASSERT_TRUE(all_are(out, 4, [&](int) { return std::copysign(x, y); }));
        }
        Floats a = numbers.lanes([&] { return numbers.any(); });
        a[0] = x;
        unsigned signs = 0;
        for (int i = 0; i < 4; ++i) signs |= unsigned{std::signbit(a[i])} << i;
        EXPECT_EQ(simd.quad_signs(a), signs);
    }
}

TEST_P(Simd, multiply_add_rounds_once_or_twice) {
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

TEST_P(Simd, fused_rounds_once) {
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

TEST_P(Simd, fused_rounds_once_whatever_is_nasty) {
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

TEST_P(Simd, compares) {
    expect_comparison(simd.less, [](float a, float b) { return a < b; });
    expect_comparison(simd.less_equal, [](float a, float b) { return a <= b; });
    expect_comparison(simd.equal, [](float a, float b) { return a == b; });
}

TEST_P(Simd, compress_moves_the_lanes_of_every_mask_to_the_front) {
    const Floats a = numbers.lanes();
    const Integers b = numbers.integer_lanes();
    Floats out;
    Integers integers;
    for (const unsigned mask : masks()) {
        std::vector<int> lanes;
        for (int i = 0; i < width; ++i)
            if (mask >> i & 1) lanes.push_back(i);
        const int count = static_cast<int>(lanes.size());
        simd.compress(mask, a, out);
        ASSERT_TRUE(all_are(out, count, [&](int i) { return a[lanes[i]]; })) << mask;
        simd.compress_integers(mask, b, integers);
        ASSERT_TRUE(all_are(integers, count, [&](int i) { return b[lanes[i]]; })) << mask;
    }
}

TEST_P(Simd, permutes_by_the_order_of_each_octant) {
    Floats out;
    Integers integers;
    for (int round = 0; round < 200; ++round) {
        const Floats a = numbers.lanes();
        const Integers b = numbers.integer_lanes();
        Integers packed;
        std::uint32_t lane[8][kMostLanes];
        for (int octant = 0; octant < 8; ++octant) {
            for (int i = 0; i < width; ++i) {
                lane[octant][i] = numbers.below(static_cast<std::uint32_t>(width));
                packed[i] |= lane[octant][i] << (4 * octant);
            }
        }
        for (int octant = 0; octant < 8; ++octant) {
            const auto from = [&](int i) { return static_cast<int>(lane[octant][i]); };
            simd.permute(a, packed, octant, out);
            ASSERT_TRUE(all_are(out, width, [&](int i) { return a[from(i)]; })) << octant;
            simd.permute_integers(b, packed, octant, integers);
            ASSERT_TRUE(all_are(integers, width, [&](int i) { return b[from(i)]; })) << octant;
        }
    }
}

TEST_P(Simd, records_come_apart_into_fields_and_together_again) {
    alignas(64) float records[8 * kMostLanes + 1], fields[8 * kMostLanes], back[8 * kMostLanes + 2];
    for (int i = 0; i <= 8 * kMostLanes; ++i) records[i] = static_cast<float>(i);
    // A quiet NaN with digits of its own: an integer field may look like one.
    const std::uint32_t triangle = 0xffc12345u;
    std::memcpy(&records[1 + 3], &triangle, sizeof(triangle));
    simd.load_records(records + 1, fields);
    for (int field = 0; field < 8; ++field) {
        for (int i = 0; i < width; ++i)
            ASSERT_EQ(bits_of(fields[field * width + i]), bits_of(records[1 + 8 * i + field]));
    }
    std::fill(back, back + 8 * kMostLanes + 2, -1.0f);
    simd.store_records(fields, back + 1);
    EXPECT_EQ(std::memcmp(back + 1, records + 1, sizeof(float) * 8 * width), 0);
    EXPECT_EQ(back[0], -1);
    EXPECT_EQ(back[1 + 8 * width], -1);
}

TEST_P(Simd, selects_and_stores_by_every_mask) {
    const Floats a = numbers.lanes([&] { return numbers.nasty(); });
    const Floats b = numbers.lanes([&] { return numbers.any(); });
    for (const unsigned mask : masks()) {
        const auto is_set = [&](int i) { return (mask >> i & 1) != 0; };
        const auto chosen = [&](int i) { return is_set(i) ? a[i] : b[i]; };
        Floats out;
        simd.select(mask, a, b, out);
        ASSERT_TRUE(all_are(out, width, chosen)) << mask;
        Floats place = b;
        simd.store_masked(mask, place, a);
        ASSERT_TRUE(all_are(place, width, chosen)) << mask;
        Integers integers, stored, pattern;
        simd.broadcast_integer(0x80000001u, stored);
        simd.store_masked_integers(mask, integers, stored);
        ASSERT_TRUE(all_are(integers, width, [&](int i) { return is_set(i) ? 0x80000001u : 0u; }))
            << mask;
        ASSERT_EQ(simd.equal_integers(integers, stored), mask);
        // As floats these are all NaN, or all zero where small numbers are flushed.
        for (int i = 0; i < width; ++i) pattern[i] = is_set(i) ? 0x7fc00001u : 1u;
        for (int i = 0; i < width; ++i) stored[i] = 0x7fc00001u;
        ASSERT_EQ(simd.equal_integers(pattern, stored), mask);
    }
}

TEST_P(Simd, takes_square_roots_rounded_once) {
    Floats out;
    const auto check = [&](const Floats& a) {
        simd.sqrt(a, out);
        // The double root of a float rounds to the float that is nearest to the exact one.
        return all_are(out, width, [&](int i) {
            return static_cast<float>(std::sqrt(static_cast<double>(a[i])));
        });
    };
    for (const float x : nasty_floats()) {
        Floats a = numbers.lanes();
        a[0] = x;
        EXPECT_TRUE(check(a)) << text(x);
    }
    for (int round = 0; round < 1000; ++round) ASSERT_TRUE(check(numbers.lanes()));
}

TEST_P(Simd, finds_the_greatest_lane_and_the_least_of_every_mask) {
    for (int round = 0; round < 20; ++round) {
        const Floats a = numbers.lanes();
        ASSERT_EQ(simd.greatest(a), *std::max_element(a.lane, a.lane + width));
        for (const unsigned mask : masks()) {
            if (mask == 0) continue;
            float least = kInfinity;
            for (int i = 0; i < width; ++i)
                if (mask >> i & 1) least = std::min(least, a[i]);
            ASSERT_EQ(simd.least(mask, a), least) << mask;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, Simd,
                         testing::ValuesIn(instruction_sets().begin(), instruction_sets().end()),
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
