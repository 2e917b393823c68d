// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/parallel.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace boxwood {
namespace {

TEST(Parallel, reduce_combines_each_piece_once) {
    const auto sum_below = [](std::size_t count, std::size_t piece) {
        return parallel_reduce(
            count, piece, std::uint64_t{0},
            [](std::size_t begin, std::size_t end) {
                std::uint64_t sum = 0;
                for (std::size_t i = begin; i < end; ++i) sum += i;
                return sum;
            },
            [](std::uint64_t a, std::uint64_t b) { return a + b; });
    };
    for (const std::size_t threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        for (const std::uint64_t count : {0, 1, 99, 100, 101, 100'000})
            EXPECT_EQ(sum_below(count, 100), count * (count > 0 ? count - 1 : 0) / 2) << count;
    }
}

}  // namespace
}  // namespace boxwood
