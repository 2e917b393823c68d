// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "boxwood/mesh/plain_lines.h"
#include "boxwood/mesh/text_numbers.h"

namespace boxwood {

/// Walks through the statements of an OBJ file, one a line: words are parted by blanks, and from #
/// to the end of a line is a comment. A backslash at the end of a line without a # joins the next
/// line to it. What it reads it moves past.
class ObjScanner {
public:
    explicit ObjScanner(std::string_view text, std::size_t first_line = 1)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), line_(first_line) {}

    /// The number of the line it stands in.
    std::size_t line() const { return line_; }

    /// Moves to the next statement, past blank lines and comments; false when there is none.
    bool find_statement() {
        while (at_ != end_) {
            if (!at_end_of_statement()) return true;
            finish_statement();
        }
        return false;
    }

    /// Whether the statement has no further word. Skips blanks.
    bool at_end_of_statement() {
        for (;;) {
            while (at_ != end_ && is_blank(*at_)) ++at_;
            if (at_ == end_ || *at_ == '\n' || *at_ == '#') return true;
            const std::size_t joint = joint_at(at_);
            if (joint == 0) return false;
            at_ += joint;
            ++line_;
        }
    }

    /// Moves to the start of the next statement's line.
    void finish_statement() {
        for (bool is_joined = true; is_joined;) {
            const auto left = static_cast<std::size_t>(end_ - at_);
            const void* found = left == 0      ? nullptr
                                : *at_ == '\n' ? at_
                                               : std::memchr(at_, '\n', left);
            const char* newline = found ? static_cast<const char*>(found) : end_;
            is_joined = found && is_joint(newline);
            at_ = found ? newline + 1 : end_;
            ++line_;
        }
    }

    /// The next word of the statement; empty when it has none.
    std::string_view word() {
        if (at_end_of_statement()) return {};
        const char* first = at_;
        while (!at_end_of_word()) ++at_;
        return {first, static_cast<std::size_t>(at_ - first)};
    }

    /// All that is left of the statement, without the blanks around it. A comment starts only
    /// after a blank.
    std::string name() {
        std::string result;
        while (!at_end_of_statement()) {
            const char* first = at_;
            while (at_ != end_ && *at_ != '\n' && joint_at(at_) == 0 &&
                   !(*at_ == '#' && is_blank(at_[-1])))
                ++at_;
            if (!result.empty()) result += ' ';
            result.append(first, at_);
            while (!result.empty() && is_blank(result.back())) result.pop_back();
        }
        return result;
    }

    /// The next word as a number, or nothing, staying before it, when it isn't one. Correctly
    /// rounded to the type; may be infinite or NaN.
    template <class Value>
    std::optional<Value> number() {
        if (at_end_of_statement()) return std::nullopt;
        const bool has_plus = at_[0] == '+' && at_ + 1 != end_ && at_[1] != '-';
        Value value = {};
        const auto [last, error] = parse_text(at_ + has_plus, end_, value);
        if (error != std::errc() || !ends_word(last)) return std::nullopt;
        if (last != end_ && *last == '#' && last[-1] == '.') return unusual_number<Value>();
        at_ = last;
        return value;
    }

    /// The whole number that comes next, or nothing, staying where it is, when there is none. The
    /// word may go on.
    std::optional<std::int64_t> integer() {
        std::int64_t value = 0;
        const bool has_plus = at_ != end_ && at_[0] == '+' && at_ + 1 != end_ && at_[1] != '-';
        const auto [last, error] = parse_text(at_ + has_plus, end_, value);
        if (error != std::errc()) return std::nullopt;
        at_ = last;
        return value;
    }

    /// Has plain lines read from here, the start of a statement: see read_on(). For speed.
    template <class Read>
    std::size_t plain_lines(const Read& read) {
        return read_on(begin_, at_, end_, line_, read);
    }

    /// Reads so many numbers and moves to the end of the line if they fill what is left of it,
    /// parted by single spaces, as most programs write them. Else false. Skips blanks. For speed.
    template <class Value>
    bool plain_line(Value* values, std::size_t count) {
        while (at_ != end_ && is_blank(*at_)) ++at_;
        const char* const newline = parse_plain_line(at_, end_, values, count);
        if (newline) at_ = newline;
        return newline != nullptr;
    }

    /// Moves past the character if it comes next.
    bool accept(char expected) {
        if (at_ == end_ || *at_ != expected) return false;
        ++at_;
        return true;
    }

    bool at_end_of_word() const { return ends_word(at_); }

private:
    static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
    }

    bool ends_word(const char* place) const {
        return place == end_ || is_blank(*place) || *place == '\n' || *place == '#' ||
               joint_at(place) > 0;
    }

    /// The size of a backslash with the line end behind it that join two lines; 0 for anything
    /// else.
    std::size_t joint_at(const char* place) const {
        if (*place != '\\') return 0;
        const std::string_view rest(place, static_cast<std::size_t>(end_ - place));
        const std::size_t size = rest.starts_with("\\\n") ? 2 : rest.starts_with("\\\r\n") ? 3 : 0;
        return size > 0 && is_joint(place + size - 1) ? size : 0;
    }

    /// Whether the line that ends there goes on in the next. Asks nothing but the line, so that
    /// all who read the text see the same statements.
    bool is_joint(const char* newline) const {
        const char* last = newline;
        if (last != begin_ && last[-1] == '\r') --last;
        if (last == begin_ || last[-1] != '\\') return false;
        while (last != begin_ && last[-1] != '\n') {
            if (*--last == '#') return false;
        }
        return true;
    }

    /// NaN and infinity as programs for Windows used to write them: -1.#IND, 1.#QNAN, 1.#INF.
    template <class Value>
    std::optional<Value> unusual_number() {
        const char* last = at_;
        while (last != end_ && (*last == '#' || !ends_word(last))) ++last;
        std::string_view word(at_, static_cast<std::size_t>(last - at_));
        const bool is_negative = word.starts_with('-');
        if (is_negative || word.starts_with('+')) word.remove_prefix(1);
        using Limits = std::numeric_limits<Value>;
        std::optional<Value> value;
        if (word.starts_with("1.#INF"))
            value = is_negative ? -Limits::infinity() : Limits::infinity();
        if (word.starts_with("1.#IND") || word.starts_with("1.#QNAN") ||
            word.starts_with("1.#SNAN"))
            value = Limits::quiet_NaN();
        if (value) at_ = last;
        return value;
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    std::size_t line_;
};

}  // namespace boxwood
