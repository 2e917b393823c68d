// SPDX-License-Identifier: Apache-2.0
// Every word of core/simd.h against plain loops, on every instruction set that this machine has.
#include "boxwood/core/simd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/simd_fixture.h"

namespace boxwood {
namespace {

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

INSTANTIATE_TEST_SUITE_P(Sets, Simd, all_instruction_sets(),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace boxwood
