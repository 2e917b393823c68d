// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace boxwood {
namespace {

TEST(Uniform, stays_in_the_half_open_unit_interval_and_fills_it_evenly) {
    constexpr int kCount = 100000;
    for (const std::uint64_t seed : {0u, 1u, 12345u}) {
        std::array<int, 10> bins{};
        double sum = 0;
        for (int i = 0; i < kCount; ++i) {
            const double x = uniform(seed, static_cast<std::uint64_t>(i), 0);
            ASSERT_GE(x, 0);
            ASSERT_LT(x, 1);
            ++bins[static_cast<std::size_t>(10 * x)];
            sum += x;
        }
        EXPECT_NEAR(sum / kCount, 0.5, 0.005);
        for (const int bin : bins) EXPECT_NEAR(bin, kCount / 10, 400);
    }
}

TEST(Uniform, is_a_function_of_its_arguments) {
    EXPECT_EQ(uniform(1, 2, 3), uniform(1, 2, 3));
    EXPECT_NE(uniform(1, 2, 3), uniform(1, 3, 2));
    EXPECT_NE(uniform(1, 2, 3), uniform(2, 1, 3));
    EXPECT_NE(uniform(0, 0, 0), 0);
}

TEST(Uniform, gives_the_same_bits_on_every_machine) {
    EXPECT_EQ(uniform(0, 0, 0), 0x1.5a2a6c2c68b00p-2);
    EXPECT_EQ(uniform(1, 2, 3), 0x1.1c3cdd59548bep-1);
    EXPECT_EQ(uniform(0xffffffffffffffffu, 0xffffffffffffffffu, 0xffffffffu), 0x1.78ce973ddec14p-3);
}

TEST(Uniform, neighbours_do_not_collide) {
    std::set<double> seen;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        for (std::uint64_t index = 0; index < 50; ++index)
            for (std::uint32_t dimension = 0; dimension < 20; ++dimension)
                seen.insert(uniform(seed, index, dimension));
    EXPECT_EQ(seen.size(), 20u * 50u * 20u);
}

TEST(Uniform, neighbours_are_not_correlated) {
    constexpr int kCount = 100000;
    double by_index = 0, by_dimension = 0, by_seed = 0;
    for (int k = 0; k < kCount; ++k) {
        const auto i = static_cast<std::uint64_t>(k);
        const double x = uniform(7, i, 0) - 0.5;
        by_index += x * (uniform(7, i + 1, 0) - 0.5);
        by_dimension += x * (uniform(7, i, 1) - 0.5);
        by_seed += x * (uniform(8, i, 0) - 0.5);
    }
    // The standard deviation of each mean is 1 / (12 sqrt(count)), or 0.00026.
    EXPECT_NEAR(by_index / kCount, 0, 0.0012);
    EXPECT_NEAR(by_dimension / kCount, 0, 0.0012);
    EXPECT_NEAR(by_seed / kCount, 0, 0.0012);
}

}  // namespace
}  // namespace boxwood
