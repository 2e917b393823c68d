// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"

namespace boxwood {
namespace {

TEST(RadixSort, sorts_by_the_bits_asked_for_and_keeps_the_order_of_equal_ones) {
    for (const std::size_t count : {0, 1, 2, 63, 64, 1000, 200'000}) {
        std::vector<std::uint64_t> keys(count);
        for (std::size_t i = 0; i < count; ++i) keys[i] = mix_bits(i + 1);
        for (const auto& [first_bit, bits] :
             {std::pair(0, 10), std::pair(0, 1), std::pair(32, 30), std::pair(40, 24),
              std::pair(5, 33), std::pair(0, 63)}) {
            const std::uint64_t mask = ((std::uint64_t{1} << bits) - 1) << first_bit;
            std::vector<std::uint64_t> expected = keys, copy = keys, found(count);
            std::stable_sort(
                expected.begin(), expected.end(),
                [&](std::uint64_t a, std::uint64_t b) { return (a & mask) < (b & mask); });
            radix_sort(copy, found, first_bit, bits);
            EXPECT_EQ(found, expected) << count << " " << first_bit << " " << bits;
        }
    }
}

TEST(RadixSort, equal_digits_are_no_work_and_no_mistake) {
    std::vector<std::uint64_t> keys(100'000), sorted(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = 7u << 20 | (keys.size() - i);
    std::vector<std::uint64_t> expected(keys.rbegin(), keys.rend());
    radix_sort(keys, sorted, 0, 40);
    EXPECT_EQ(sorted, expected);
    radix_sort(sorted, keys, 30, 20);
    EXPECT_EQ(keys, expected);
}

}  // namespace
}  // namespace boxwood
