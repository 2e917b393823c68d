// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/plain_lines.h"

#include <algorithm>

#include "boxwood/mesh/text_kernels/text_kernels.h"

namespace boxwood {

namespace {

const TextKernels& kernels() { return text_kernels(preferred_instruction_set()); }

/// Has read(text, most) read what comes next, of which there may be too little around it, from a
/// copy with zeros around it, which are no part of a plain line.
template <class Read>
std::size_t read_copied(PlainText& text, std::size_t most, const Read& read) {
    constexpr std::ptrdiff_t kRoom = 2 * kTextAhead;
    char copy[kTextBehind + kRoom + kTextAhead] = {};
    char* const start = copy + kTextBehind;
    std::copy_n(text.at, std::min(text.end - text.at, kRoom), start);
    PlainText copied = {copy, start, std::end(copy)};
    const std::size_t count = read(copied, most);
    text.at += copied.at - start;
    return count;
}

/// Has read(text, from, most) read up to so many lines, whose values go from the given one on.
template <class Read>
std::size_t read_plain(PlainText& text, std::size_t most, const Read& read) {
    std::size_t count = 0;
    const auto read_some = [&](PlainText& some, std::size_t some_most) {
        return read(some, count, some_most);
    };
    while (count < most && text.at - text.begin < kTextBehind) {
        if (read_copied(text, 1, read_some) == 0) return count;
        ++count;
    }
    count += read_some(text, most - count);
    if (text.end - text.at < kTextAhead) count += read_copied(text, most - count, read_some);
    return count;
}

}  // namespace

std::size_t read_plain_rows(PlainText& text, const LinePrefix& prefix, std::size_t columns,
                            double* numbers, std::size_t most) {
    return read_plain(text, most, [&](PlainText& some, std::size_t from, std::size_t some_most) {
        return kernels().read_rows(some, prefix, columns, numbers + columns * from, some_most);
    });
}

std::size_t read_plain_triangles(PlainText& text, const LinePrefix& prefix, std::uint32_t first,
                                 std::uint32_t count, int* indices, std::size_t most) {
    return read_plain(text, most, [&](PlainText& some, std::size_t from, std::size_t some_most) {
        return kernels().read_triangles(some, prefix, first, count, indices + 3 * from, some_most);
    });
}

LineCounts line_counts(std::string_view text) {
    return kernels().count_lines(text.data(), text.data() + text.size());
}

}  // namespace boxwood
