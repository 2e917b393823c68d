// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/mesh/text_kernels/text_bits.h"

namespace boxwood {

template <class Bytes>
BOXWOOD_KERNEL LineCounts count_lines(const char* at, const char* end) {
    LineCounts counts;
    bool is_start = false;  // whether the next character begins a line, and not the first
    for (; kFirstIsLowest && end - at >= kTextWindow; at += kTextWindow) {
        prefetch_text(at);
        const auto is_line_end = [](auto x) { return Bytes::equal(x, '\n'); };
        const auto is_doubtful = [](auto x) { return Bytes::less(x, '!') | Bytes::equal(x, '#'); };
        const std::uint64_t line_ends = text_mask<Bytes>(at, is_line_end);
        const std::uint64_t starts = line_ends << 1 | is_start;
        counts.line_ends += static_cast<std::size_t>(__builtin_popcountll(line_ends));
        counts.doubtful += static_cast<std::size_t>(
            __builtin_popcountll(starts & text_mask<Bytes>(at, is_doubtful)));
        is_start = line_ends >> 63 != 0;
    }
    for (; at != end; ++at) {
        counts.doubtful += is_start && (static_cast<unsigned char>(*at) <= ' ' || *at == '#');
        is_start = *at == '\n';
        counts.line_ends += is_start;
    }
    return counts;
}

}  // namespace boxwood
