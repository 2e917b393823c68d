// SPDX-License-Identifier: Apache-2.0
// Masks of the next 64 characters tell all that is to be known of a row: where it ends, what parts
// numbers, what is a point, what is a digit. Where the digits of a number and the power of ten are
// exact, a division rounds correctly (Clinger, "How to read floating point numbers accurately",
// 1990).
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/mesh/text_kernels/text_bits.h"
#include "boxwood/mesh/text_kernels/text_digits.h"

namespace boxwood {

constexpr unsigned kMostTextDigits = 16;

/// 10^n, and those times -1. Only the first are exact, and needed.
struct SignedPowers {
    double of[2][kTextWindow] = {};

    constexpr SignedPowers() {
        double power = 1;
        for (std::size_t n = 0; n < kTextWindow; ++n, power *= 10) {
            of[0][n] = power;
            of[1][n] = -power;
        }
    }
};

inline constexpr SignedPowers kSignedPowers;

BOXWOOD_KERNEL double as_double(std::uint64_t whole) {
    return static_cast<double>(static_cast<std::int64_t>(whole));
}

enum class RowKind {
    usual,    ///< as most are
    unusual,  ///< maybe plain, but longer than the window, or with a number of too many digits
    other     ///< not plain
};

/// Reads the numbers of a usual row and moves past its line's end. Whether it is usual is asked in
/// the end, as nearly all are. From others it may move anywhere.
template <class Bytes>
BOXWOOD_KERNEL RowKind read_row(const char*& at, std::size_t columns, double* row) {
    const std::uint64_t line_ends =
        text_mask<Bytes>(at, [](auto x) { return Bytes::equal(x, '\n'); });
    std::uint64_t spaces = text_mask<Bytes>(at, [](auto x) { return Bytes::equal(x, ' '); });
    std::uint64_t points = text_mask<Bytes>(at, [](auto x) { return Bytes::equal(x, '.'); });
    const std::uint64_t digits = text_mask<Bytes>(at, [](auto x) { return Bytes::digits(x); });
    if (line_ends == 0) return RowKind::unusual;
    const auto line_end = static_cast<unsigned>(__builtin_ctzll(line_ends));
    const char* const next = at + line_end + 1;
    const unsigned size = end_of_numbers(at, line_end);
    const std::uint64_t line = (std::uint64_t{1} << size) - 1;
    spaces &= line;
    if (static_cast<unsigned>(__builtin_popcountll(spaces)) != columns - 1) return RowKind::other;

    points |= line_ends;  // so that there are some
    unsigned begin = 0, all_counts = 0, any_count = 0;
    std::uint64_t any_whole = 0;
    for (std::size_t k = 0; k < columns; ++k) {
        const unsigned end =
            k + 1 < columns ? static_cast<unsigned>(__builtin_ctzll(spaces)) : size;
        const auto point = static_cast<unsigned>(__builtin_ctzll(points));
        const unsigned is_negative = at[begin] == '-';
        unsigned count = end - begin - is_negative;
        std::uint64_t whole;
        if (point - begin < end - begin) [[likely]] {
            const unsigned decimals = end - 1 - point;
            --count;
            whole = whole_number<Bytes>(without_point<Bytes>(at + end, decimals), count);
            row[k] = as_double(whole) / kSignedPowers.of[is_negative][decimals];
            points &= points - 1;
        } else {
            whole = whole_number<Bytes>(Bytes::load_sixteen(at + end - 16), count);
            row[k] = as_double(whole) / kSignedPowers.of[is_negative][0];
        }
        all_counts += count;
        any_count |= count - 1;
        any_whole |= whole;
        spaces &= spaces - 1;
        begin = end + 1;
    }
    at = next;
    // All that was taken for a digit is one if the line has as many.
    const bool is_usual = any_count < kMostTextDigits && any_whole >> 53 == 0 &&
                          static_cast<unsigned>(__builtin_popcountll(digits & line)) == all_counts;
    return is_usual ? RowKind::usual : RowKind::unusual;
}

/// The loop over rows, made for a number of columns that is known, or 0 for any.
template <class Bytes, std::size_t kColumns>
BOXWOOD_KERNEL std::size_t read_some_rows(PlainText& text, const LinePrefix& prefix,
                                          std::size_t any_columns, double* numbers,
                                          std::size_t most) {
    const std::size_t columns = kColumns > 0 ? kColumns : any_columns;
    const char* const end = text.end;
    return read_lines(text, prefix, most, [&](const char*& at, std::size_t i) {
        const char* const start = at;
        double* const row = numbers + i * columns;
        const RowKind kind = read_row<Bytes>(at, columns, row);
        if (kind == RowKind::unusual) {
            at = start;
            return read_unusual_row(at, end, columns, row);
        }
        return kind == RowKind::usual;
    });
}

template <class Bytes>
BOXWOOD_KERNEL std::size_t read_rows(PlainText& text, const LinePrefix& prefix, std::size_t columns,
                                     double* numbers, std::size_t most) {
    return columns == 3 ? read_some_rows<Bytes, 3>(text, prefix, columns, numbers, most)
                        : read_some_rows<Bytes, 0>(text, prefix, columns, numbers, most);
}

}  // namespace boxwood
