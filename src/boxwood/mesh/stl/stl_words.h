// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "boxwood/core/vec.h"
#include "boxwood/mesh/text_numbers.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

/// Walks through the words of an STL text. Unlike most formats it has no comments, and its lines
/// matter only for names.
class StlWords {
public:
    StlWords(std::string_view text, std::size_t first_line)
        : at_(text.data()), end_(text.data() + text.size()), line_(first_line) {}

    /// The line of the word that was read last.
    std::size_t line() const { return line_; }

    /// The next word; empty at the end.
    std::string_view word() {
        for (; at_ != end_ && is_blank(*at_); ++at_) line_ += *at_ == '\n';
        const char* first = at_;
        while (at_ != end_ && !is_blank(*at_)) ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }

    /// Moves past the keyword if it comes next as it is written here; quicker than word().
    bool accept(std::string_view keyword) {
        for (; at_ != end_ && is_blank(*at_); ++at_) line_ += *at_ == '\n';
        const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
        if (!rest.starts_with(keyword)) return false;
        if (rest.size() > keyword.size() && !is_blank(rest[keyword.size()])) return false;
        at_ += keyword.size();
        return true;
    }

    /// Reads the three numbers of a vector and moves to the end of the line if they fill what is
    /// left of it, parted by single spaces, as most programs write them. Else false, staying where
    /// it is. For speed.
    bool plain_line(Vec3d& vector) {
        const char* first = at_;
        while (first != end_ && *first == ' ') ++first;
        const char* const newline = parse_plain_line(first, end_, vector.data(), 3);
        if (newline) at_ = newline;
        return newline != nullptr;
    }

    /// What is left of the line, without blanks around it.
    std::string_view rest_of_line() {
        const char* first = at_;
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
        const char* last = at_;
        while (first != last && is_blank(*first)) ++first;
        while (first != last && is_blank(last[-1])) --last;
        return {first, static_cast<std::size_t>(last - first)};
    }

    /// The word as messages show it.
    static std::string shown(std::string_view word) {
        return word.empty() ? "the end of the file" : quoted(word);
    }

private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    const char* at_;
    const char* end_;
    std::size_t line_;
};

/// Whether the word is the keyword, which is in lower case, in any case.
inline bool is_keyword(std::string_view word, std::string_view keyword) {
    if (word.size() != keyword.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != keyword[i])
            return false;
    }
    return true;
}

/// The word as a number, or nothing when it isn't one.
inline std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [last, error] = parse_text(word.data(), end, value);
    if (word.empty() || error != std::errc() || last != end) return std::nullopt;
    return value;
}

}  // namespace boxwood
