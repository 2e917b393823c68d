// SPDX-License-Identifier: Apache-2.0
// Whole numbers of at most eight digits: where they end is told by a mask of what isn't a digit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/mesh/text_kernels/text_bits.h"
#include "boxwood/mesh/text_kernels/text_digits.h"

namespace boxwood {

/// Reads a line's three numbers and moves past its end. Else false.
template <class Bytes>
BOXWOOD_KERNEL bool read_triangle(const char*& at, std::uint32_t first, std::uint32_t count,
                                  int* indices) {
    constexpr unsigned kMostDigits = 8;
    constexpr int kSize = 32;
    // Such a line has no more, and what is beyond are gaps, so that there are always enough.
    const std::uint64_t line_ends =
        text_mask<Bytes, kSize>(at, [](auto x) { return Bytes::equal(x, '\n'); });
    std::uint64_t gaps = ~text_mask<Bytes, kSize>(at, [](auto x) { return Bytes::digits(x); }) |
                         ~std::uint64_t{0} << 32;
    const auto next_gap = [&] {
        const auto place = static_cast<unsigned>(__builtin_ctzll(gaps));
        gaps &= gaps - 1;
        return place;
    };
    if (line_ends == 0) return false;
    // The next line's place comes from here, so that it doesn't wait for all that follows.
    const auto line_end = static_cast<unsigned>(__builtin_ctzll(line_ends));
    const unsigned a = next_gap(), b = next_gap(), c = next_gap();
    const unsigned sizes[3] = {a, b - a - 1, c - b - 1};
    if (((sizes[0] - 1) | (sizes[1] - 1) | (sizes[2] - 1)) >= kMostDigits) return false;
    if (((at[a] ^ ' ') | (at[b] ^ ' ')) != 0) return false;
    const auto digits = [&](unsigned end, unsigned size) {
        return last_digits<Bytes>(Bytes::load_sixteen(at + end - 16), size);
    };
    const std::uint64_t two =
        Bytes::numbers(Bytes::last_halves(digits(a, sizes[0]), digits(b, sizes[1])));
    const std::uint64_t third = Bytes::numbers(digits(c, sizes[2]));
    const std::uint32_t corners[3] = {static_cast<std::uint32_t>(two) - first,
                                      static_cast<std::uint32_t>(two >> 32) - first,
                                      static_cast<std::uint32_t>(third >> 32) - first};
    if (corners[0] >= count || corners[1] >= count || corners[2] >= count) return false;
    if (c != end_of_numbers(at, line_end)) return false;
    for (int k = 0; k < 3; ++k) indices[k] = static_cast<int>(corners[k]);
    at += line_end + 1;
    return true;
}

template <class Bytes>
BOXWOOD_KERNEL std::size_t read_triangles(PlainText& text, const LinePrefix& prefix,
                                          std::uint32_t first, std::uint32_t count, int* indices,
                                          std::size_t most) {
    return read_lines(text, prefix, most, [&](const char*& at, std::size_t i) {
        return read_triangle<Bytes>(at, first, count, indices + 3 * i);
    });
}

}  // namespace boxwood
