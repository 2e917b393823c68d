// SPDX-License-Identifier: Apache-2.0
// The parser is the library's. What it reports is put into our words, and with a line each time:
// the library gives none for keys that repeat and numbers that overflow.
#include "boxwood/core/parse_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"

namespace boxwood {

using nlohmann::json;

namespace {

/// The line in which the byte at this place stands.
std::size_t line_of(std::string_view text, std::size_t place) {
    const std::string_view before = text.substr(0, place);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

/// Walks through the text for the parser and leaves word of how far it has come.
class Cursor {
public:
    // NOLINTBEGIN(readability-identifier-naming): the names that the standard asks iterators for.
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    // NOLINTEND(readability-identifier-naming)

    Cursor(const char* at, const char*& furthest) : at_(at), furthest_(&furthest) {}

    reference operator*() const { return *at_; }
    Cursor& operator++() {
        *furthest_ = ++at_;
        return *this;
    }
    Cursor operator++(int) {
        const Cursor before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Cursor& other) const { return at_ == other.at_; }

private:
    const char* at_;
    const char** furthest_;
};

class JsonParser {
public:
    JsonParser(std::string_view text, const std::string& file, std::uint64_t max_depth)
        : text_(text), file_(file), max_depth_(max_depth) {}

    json parse() {
        // The library takes a zero byte for the end of the file.
        if (const std::size_t zero = text_.find('\0'); zero != text_.npos)
            fail(zero, "found a zero byte, expected text");
        const char* const begin = text_.data();
        at_ = begin;
        try {
            return json::parse(Cursor(begin, at_), Cursor(begin + text_.size(), at_),
                               [this](int depth, json::parse_event_t event, json& parsed) {
                                   check_depth(depth);
                                   check_keys(event, parsed);
                                   return true;
                               });
        } catch (const json::parse_error& error) {
            const std::size_t place = error.byte > 0 ? error.byte - 1 : 0;
            fail(place, reason(error.what(), place));
        } catch (const json::out_of_range&) {
            fail_number();
        }
    }

private:
    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        throw ParseError(file_, line_of(text_, place), message);
    }

    /// How many bytes the parser has read.
    std::size_t read() const { return static_cast<std::size_t>(at_ - text_.data()); }

    void check_depth(int depth) const {
        if (static_cast<std::uint64_t>(depth) > max_depth_)
            fail(read() - 1,
                 fmt::format("found a value in {} others, expected at most {}", depth, max_depth_));
    }

    /// JSON's own rule leaves open which of two equal keys counts, so neither does.
    void check_keys(json::parse_event_t event, const json& parsed) {
        if (event == json::parse_event_t::object_start) {
            keys_.emplace_back();
        } else if (event == json::parse_event_t::object_end) {
            keys_.pop_back();
        } else if (event == json::parse_event_t::key && !keys_.back().insert(parsed).second) {
            fail(read() - 1, fmt::format("found key {} twice in one object, expected it once",
                                         description(parsed)));
        }
    }

    /// The number is the last thing read, but for the character behind it.
    [[noreturn]] void fail_number() const {
        constexpr const char* kNumber = "+-.0123456789Ee";
        const std::size_t before = text_.find_last_not_of(kNumber, read() - 2);
        const std::size_t begin = before == text_.npos ? 0 : before + 1;
        const std::string_view number =
            text_.substr(begin, text_.find_first_not_of(kNumber, begin) - begin);
        fail(begin, fmt::format("found {}, expected a number of at most 1.8e308 in size",
                                number.size() > 40 ? fmt::format("{}...", number.substr(0, 36))
                                                   : std::string(number)));
    }

    /// The library says "syntax error while parsing C - ", and then "unexpected A; expected B" or
    /// "what is wrong; last read: 'A'", with or without "; expected B".
    std::string reason(std::string_view what, std::size_t place) const {
        const std::string_view fault = cut(what, what.find(" - "), " - ").second;
        constexpr std::string_view kLastRead = "; last read: '", kBetween = "'; expected ";
        const auto [wrong, read] = cut(fault, fault.find(kLastRead), kLastRead);
        if (!read.empty()) {
            const auto [found, expected] = cut(read, read.rfind(kBetween), kBetween);
            // What was read last starts with the token, except in this case.
            const std::string_view token = wrong == "invalid literal" ? word_at(place)
                                           : expected.empty() ? read.substr(0, read.size() - 1)
                                                              : found;
            return fmt::format("found {}, expected {} ({})", description(token),
                               expected.empty() ? "JSON" : expected, wrong);
        }
        constexpr std::string_view kUnexpected = "unexpected ", kExpected = "; expected ";
        const auto [found, expected] = cut(fault, fault.find(kExpected), kExpected);
        if (!found.starts_with(kUnexpected) || expected.empty()) return std::string(what);
        return fmt::format("found {}, expected {}", found.substr(kUnexpected.size()), expected);
    }

    std::string_view word_at(std::size_t place) const {
        constexpr const char* kBorders = " \t\r\n,:[]{}\"";
        const std::size_t before = place > 0 ? text_.find_last_of(kBorders, place - 1) : text_.npos;
        const std::size_t begin = before == text_.npos ? 0 : before + 1;
        return text_.substr(begin, text_.find_first_of(kBorders, place) - begin);
    }

    /// What stands before and behind the separator at a place; all before it when there is none.
    static std::pair<std::string_view, std::string_view> cut(std::string_view text,
                                                             std::size_t place,
                                                             std::string_view separator) {
        if (place == text.npos) return {text, {}};
        return {text.substr(0, place), text.substr(place + separator.size())};
    }

    std::string_view text_;
    const std::string& file_;
    std::uint64_t max_depth_;
    const char* at_ = nullptr;
    std::vector<std::set<std::string>> keys_;  ///< of the objects that are open
};

}  // namespace

json parse_json(std::string_view text, const std::string& file, std::uint64_t max_depth) {
    return JsonParser(text, file, max_depth).parse();
}

std::string description(const json& value) {
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > 40) text = text.substr(0, 36) + (value.is_string() ? "...\"" : "...");
    return text;
}

}  // namespace boxwood
