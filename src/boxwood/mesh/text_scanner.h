// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "boxwood/mesh/plain_lines.h"
#include "boxwood/mesh/text_numbers.h"

namespace boxwood {

/// Walks through text made of lines of words: words are parted by blanks, lines end in LF or CRLF,
/// and from # to the end of a line is a comment. What it reads it moves past.
class TextScanner {
public:
    explicit TextScanner(std::string_view text, std::size_t first_line = 1)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), line_(first_line) {}

    /// The number of the line it stands in.
    std::size_t line() const { return line_; }
    std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

    /// Moves to the next word, past blank lines and comments; false when there is none.
    bool find_word() {
        while (at_ != end_) {
            if (!at_end_of_line()) return true;
            finish_line();
        }
        return false;
    }

    /// Whether the line holds no further word. Skips blanks.
    bool at_end_of_line() {
        while (at_ != end_ && is_blank(*at_)) ++at_;
        return at_ == end_ || *at_ == '\n' || *at_ == '#';
    }

    /// Moves to the start of the next line.
    void finish_line() {
        ++line_;
        if (at_ != end_ && *at_ == '\n') {
            ++at_;
            return;
        }
        const auto left = static_cast<std::size_t>(end_ - at_);
        const void* newline = left > 0 ? std::memchr(at_, '\n', left) : nullptr;
        at_ = newline ? static_cast<const char*>(newline) + 1 : end_;
    }

    /// The next word of the line; empty when it holds none.
    std::string_view word() {
        if (at_end_of_line()) return {};
        const char* first = at_;
        while (at_ != end_ && !ends_word(*at_)) ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }

    /// Moves past the given characters if they come next.
    bool accept(std::string_view expected) {
        if (!rest().starts_with(expected)) return false;
        at_ += expected.size();
        return true;
    }

    /// The next word as a number, or nothing, staying before it, when it isn't one. Correctly
    /// rounded; may be infinite or NaN.
    std::optional<double> number() { return parsed<double>(); }

    /// The next word as a whole number of 64 bits, or nothing, staying before it.
    std::optional<std::int64_t> integer() { return parsed<std::int64_t>(); }

    /// Has plain lines read from here, the start of a line: see read_on(). For speed.
    template <class Read>
    std::size_t plain_lines(const Read& read) {
        return read_on(begin_, at_, end_, line_, read);
    }

private:
    static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
    }
    static bool ends_word(char c) { return is_blank(c) || c == '\n' || c == '#'; }

    template <class Value>
    std::optional<Value> parsed() {
        if (at_end_of_line()) return std::nullopt;
        const bool has_plus = at_[0] == '+' && at_ + 1 != end_ && at_[1] != '-';
        Value value = {};
        const auto [last, error] = parse_text(at_ + has_plus, end_, value);
        if (error != std::errc() || (last != end_ && !ends_word(*last))) return std::nullopt;
        at_ = last;
        return value;
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    std::size_t line_;
};

/// The word as messages show it: in quotes, cut when long, without characters that might not print.
inline std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string result(1, '\'');
    for (const char c : word.substr(0, kLongest)) result += c >= ' ' && c <= '~' ? c : '?';
    if (word.size() > kLongest) result += "...";
    result += '\'';
    return result;
}

}  // namespace boxwood
