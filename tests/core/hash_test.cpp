// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "boxwood/core/parallel.h"

namespace boxwood {
namespace {

TEST(Hash, is_what_files_have_on_them) {
    EXPECT_EQ(hash_of({}), 0x2d06800538d394c2u);
    const std::vector<std::byte> bytes(3'000'000, std::byte{7});
    const std::uint64_t hash = hash_of(bytes);
    const ThreadLimit limit(1);
    EXPECT_EQ(hash_of(bytes), hash);
}

TEST(Hash, every_byte_counts_and_so_does_the_length) {
    std::vector<std::byte> bytes(2'100'000);
    std::set<std::uint64_t> hashes = {hash_of(bytes), hash_of({})};
    for (const std::size_t size : {1u, 2u, 1u << 20, (1u << 20) + 1})
        hashes.insert(hash_of(std::span(bytes).first(size)));
    for (std::size_t i = 0; i < bytes.size(); i += 99'999) {
        bytes[i] = std::byte{1};
        hashes.insert(hash_of(bytes));
        bytes[i] = std::byte{0};
    }
    EXPECT_EQ(hashes.size(), 6u + 22u);
}

}  // namespace
}  // namespace boxwood
