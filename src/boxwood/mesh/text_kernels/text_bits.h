// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "boxwood/core/simd.h"
#include "boxwood/mesh/text_kernels/text_kernels.h"

namespace boxwood {

/// Whether the first characters are the lowest ones of a word. Where not, no line is taken for
/// plain.
constexpr bool kFirstIsLowest = std::endian::native == std::endian::little;

/// The mask of a window of characters, or of a part of it, of which a vector's mask is taken.
template <class Bytes, int kSize = kTextWindow, class MaskOf>
BOXWOOD_KERNEL std::uint64_t text_mask(const char* at, const MaskOf& mask_of) {
    std::uint64_t mask = 0;
    for (int i = 0; i < kSize; i += Bytes::kWidth) mask |= mask_of(Bytes::load(at + i)) << i;
    return mask;
}

/// Asks for the text some lines ahead: machines that look ahead by themselves stop where a page
/// ends.
BOXWOOD_KERNEL void prefetch_text(const char* at) { __builtin_prefetch(at + 4096); }

BOXWOOD_KERNEL bool has_prefix(const char* at, const LinePrefix& prefix) {
    std::uint64_t text;
    std::memcpy(&text, at, sizeof(text));
    return ((text ^ prefix.text) & prefix.mask) == 0;
}

/// Where a line's numbers end: with the line, but for a space and a CR before that.
BOXWOOD_KERNEL unsigned end_of_numbers(const char* line, unsigned line_end) {
    unsigned end = line_end;
    if (line[static_cast<int>(end) - 1] < '.') [[unlikely]] {
        // A branch, which is guessed, so that nobody waits for the characters it looks at; without
        // this line compilers would compute what it does.
        asm volatile("");
        if (end > 0 && line[end - 1] == '\r') --end;
        if (end > 0 && line[end - 1] == ' ') --end;
    }
    return end;
}

/// Has read_line(at, i) read lines of the prefix, from behind it and blanks on, and move past their
/// ends, up to that many, until one isn't plain or hasn't enough around it. Returns how many.
template <class ReadLine>
BOXWOOD_KERNEL std::size_t read_lines(PlainText& text, const LinePrefix& prefix, std::size_t most,
                                      const ReadLine& read_line) {
    if (!kFirstIsLowest || text.at - text.begin < kTextBehind) return 0;
    const LinePrefix expected = prefix;
    const char *at = text.at, *const end = text.end;
    std::size_t count = 0;
    for (; count < most && end - at >= kTextAhead && has_prefix(at, expected); ++count) {
        prefetch_text(at);
        const char* next = at + expected.size;
        for (const char* const last = at + kMostPrefix; next < last && *next == ' ';) ++next;
        if (!read_line(next, count)) break;
        at = next;
    }
    text.at = at;
    return count;
}

}  // namespace boxwood
