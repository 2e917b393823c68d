// SPDX-License-Identifier: Apache-2.0
// Numbers as text files of meshes have them: a few digits, maybe a point. Eight digits are turned
// into a number at once (Lemire, "Number parsing at a gigabyte per second", 2021), and where these
// and the power of ten are exact, one division rounds correctly (Clinger, "How to read floating
// point numbers accurately", 1990). All others are left to those who can read them.
#pragma once

#include <fast_float/fast_float.h>

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <type_traits>

namespace boxwood {

inline constexpr auto kPowersOfTen = [] {
    std::array<std::uint64_t, 17> powers = {1};
    for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
    return powers;
}();

/// Digits in a row and how many there are. Beyond 19 the value has overflowed.
struct Digits {
    std::uint64_t value = 0;
    std::size_t count = 0;
};

/// Moves past digits one by one.
inline Digits read_digits(const char*& at, const char* end, Digits before = {}) {
    Digits result = before;
    const char* const first = at;
    for (; at != end; ++at) {
        const auto digit = static_cast<unsigned>(*at - '0');
        if (digit > 9) break;
        result.value = result.value * 10 + digit;
    }
    result.count += static_cast<std::size_t>(at - first);
    return result;
}

/// The same, the first eight at once.
inline Digits read_many_digits(const char*& at, const char* end) {
    if (std::endian::native != std::endian::little || end - at < 8) return read_digits(at, end);
    std::uint64_t bytes;
    std::memcpy(&bytes, at, 8);
    // Each byte of a digit becomes its value, 0 to 9; others have a high bit or more than 9.
    bytes ^= 0x3030303030303030;
    const std::uint64_t others =
        (((bytes & 0x7f7f7f7f7f7f7f7f) + 0x7676767676767676) | bytes) & 0x8080808080808080;
    const auto count = static_cast<std::size_t>(std::countr_zero(others)) / 8;
    if (count == 0) return {};
    // As the last of eight, with zeros before them; then pairs, fours and all of them.
    bytes <<= 8 * (8 - count);
    bytes = bytes * 10 + (bytes >> 8);
    bytes = ((bytes & 0x000000ff000000ff) * 0x000f424000000064 +
             (bytes >> 16 & 0x000000ff000000ff) * 0x0000271000000001) >>
            32;
    at += count;
    return count < 8 ? Digits{bytes, count} : read_digits(at, end, {bytes, count});
}

/// Reads a whole number as std::from_chars does.
inline std::from_chars_result parse_text(const char* first, const char* last, std::int64_t& value) {
    const char* at = first;
    const bool is_negative = at != last && *at == '-';
    at += is_negative;
    const Digits digits = read_digits(at, last);
    constexpr std::size_t kMostDigits = 18;
    if (digits.count == 0 || digits.count > kMostDigits) return std::from_chars(first, last, value);
    const auto number = static_cast<std::int64_t>(digits.value);
    value = is_negative ? -number : number;
    return {at, std::errc()};
}

/// Reads a float or a double, correctly rounded, as std::from_chars does; what is beyond its range
/// becomes infinite or 0.
template <class Value>
requires std::is_floating_point_v<Value> std::from_chars_result parse_text(const char* first,
                                                                           const char* last,
                                                                           Value& value) {
    constexpr bool kIsDouble = sizeof(Value) == sizeof(double);
    constexpr std::uint64_t kMostExact = std::uint64_t{1} << (kIsDouble ? 53 : 24);
    constexpr std::size_t kMostDigits = 19, kMostDecimals = kIsDouble ? 16 : 10;
    const char* at = first;
    const bool is_negative = at != last && *at == '-';
    at += is_negative;
    const Digits whole = read_digits(at, last);
    Digits fraction;
    if (at != last && *at == '.') fraction = read_many_digits(++at, last);
    const std::size_t count = whole.count + fraction.count;
    const bool has_exponent = at != last && (*at | ' ') == 'e';
    if (count > 0 && count <= kMostDigits && fraction.count <= kMostDecimals && !has_exponent) {
        const std::uint64_t scale = kPowersOfTen[fraction.count];
        const std::uint64_t digits = whole.value * scale + fraction.value;
        if (digits <= kMostExact) {
            const Value number = static_cast<Value>(static_cast<std::int64_t>(digits)) /
                                 static_cast<Value>(static_cast<std::int64_t>(scale));
            value = is_negative ? -number : number;
            return {at, std::errc()};
        }
    }
    const auto [end, error] = fast_float::from_chars(first, last, value);
    // Its newer versions report what older ones only round, to 0 or to infinity.
    return {end, error == std::errc::result_out_of_range ? std::errc() : error};
}

/// Reads numbers as most programs write them: parted by one space each, the last one followed by
/// the end of the line, maybe after another space. Returns where that is, or null when anything
/// else is there.
template <class Value>
const char* parse_plain_line(const char* at, const char* end, Value* values, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        if (k > 0 && (at == end || *at++ != ' ')) return nullptr;
        const auto [last, error] = parse_text(at, end, values[k]);
        if (error != std::errc()) return nullptr;
        at = last;
    }
    for (const char blank : {' ', '\r'}) at += at != end && *at == blank;
    return at != end && *at == '\n' ? at : nullptr;
}

}  // namespace boxwood
