// SPDX-License-Identifier: Apache-2.0
// Most lines of a text file of a mesh are alike: a keyword maybe, spaces, a few numbers parted by
// one space each, maybe another one, the end of the line. Such plain lines are read many at a time,
// without a branch for each character; whatever else a line has ends that, and is left to the
// reader of the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace boxwood {

/// A text and the place that is to be read, the start of a line.
struct PlainText {
    const char* begin;
    const char* at;
    const char* end;
};

/// What lines begin with: at most eight characters.
struct LinePrefix {
    std::uint64_t text = 0, mask = 0;  ///< as in memory
    unsigned size = 0;

    constexpr LinePrefix() = default;
    /// Of a literal of at most eight characters.
    template <std::size_t N>
    explicit constexpr LinePrefix(const char (&prefix)[N]) : size(N - 1) {
        static_assert(N <= 9);
        for (unsigned i = 0; i < size; ++i) {
            text |= std::uint64_t{static_cast<unsigned char>(prefix[i])} << 8 * i;
            mask |= std::uint64_t{0xff} << 8 * i;
        }
    }
};

struct LineCounts {
    std::size_t line_ends = 0;
    /// Lines, without the first, that begin with a # or a character up to a space, such as another
    /// blank or a line end, so that they may hold nothing.
    std::size_t doubtful = 0;
};

/// Reads lines of the prefix and so many numbers, at most 3.4e38 in size, from the text's place on,
/// which it moves past them, up to the first that isn't plain, or as many as are given. Returns how
/// many. The numbers, correctly rounded, follow one another, line by line, and those behind them
/// may have been written to, as far as there are given lines.
std::size_t read_plain_rows(PlainText& text, const LinePrefix& prefix, std::size_t columns,
                            double* numbers, std::size_t most);

/// Reads lines of the prefix and three whole numbers, at least the first and less than count more,
/// likewise. What is left when the first is taken away follows one another.
std::size_t read_plain_triangles(PlainText& text, const LinePrefix& prefix, std::uint32_t first,
                                 std::uint32_t count, int* indices, std::size_t most);

LineCounts line_counts(std::string_view text);

/// Lets read(PlainText&), one of these, go on from where a scanner stands, the start of a line, and
/// moves it past the lines that were read. Returns how many, which read() must return, too.
template <class Read>
std::size_t read_on(const char* begin, const char*& at, const char* end, std::size_t& line,
                    const Read& read) {
    PlainText text = {begin, at, end};
    const std::size_t count = read(text);
    at = text.at;
    line += count;
    return count;
}

}  // namespace boxwood
