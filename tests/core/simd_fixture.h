// SPDX-License-Identifier: Apache-2.0
// What tests of the vocabulary of core/simd.h share: numbers that something may go wrong with, and
// each word as a plain function on every instruction set.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "boxwood/core/float_bits.h"
#include "boxwood/core/simd.h"
#include "core/vocabulary.h"

namespace boxwood {

/// How tests that it is a parameter of are listed.
inline void PrintTo(const Named<InstructionSet>& set, std::ostream* out) { *out << set.name; }

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
inline bool are_same(float a, float b) {
    return std::isnan(a) ? std::isnan(b) : bits_of(a) == bits_of(b);
}

inline std::string text(float x) {
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "%a", static_cast<double>(x));
    return buffer;
}

/// Numbers that something may go wrong with.
inline const std::vector<float>& nasty_floats() {
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

inline const Vocabulary& vocabulary(InstructionSet set) {
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

/// Each instruction set that there is a name for.
inline auto all_instruction_sets() {
    return testing::ValuesIn(instruction_sets().begin(), instruction_sets().end());
}

}  // namespace boxwood
