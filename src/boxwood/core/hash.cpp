// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/hash.h"

// Without a library to link, for whoever links this one.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <vector>

#include "boxwood/core/parallel.h"

namespace boxwood {

std::uint64_t hash_of(std::span<const std::byte> bytes) {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    std::vector<std::uint64_t> hashes((bytes.size() + kPiece - 1) / kPiece);
    parallel_for(hashes.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t first = i * kPiece;
            hashes[i] = XXH3_64bits(bytes.data() + first, std::min(kPiece, bytes.size() - first));
        }
    });
    return XXH3_64bits(hashes.data(), hashes.size() * sizeof(hashes[0]));
}

}  // namespace boxwood
