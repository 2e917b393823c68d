// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxwood/core/limits.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// A value in a JSON file that knows its place, so that whatever is wrong with it is reported as
/// "file:$.Path.To[3].It: found ..., expected ...". Every function throws ParseError.
class JsonReader {
public:
    /// The whole content of a file. Throws ParseError as parse_json() does.
    static JsonReader parse(std::string_view text, const std::string& file,
                            const Limits& limits = {});

    /// The value of a key of an object.
    JsonReader operator[](const std::string& key) const;
    /// The same, or nothing when there is no such key.
    std::optional<JsonReader> find(const std::string& key) const;
    /// Demands an object with exactly these keys.
    void expect_keys(std::initializer_list<std::string_view> keys) const { expect_keys(keys, {}); }
    /// Demands an object with these keys, and no others but the optional ones.
    void expect_keys(std::initializer_list<std::string_view> keys,
                     std::initializer_list<std::string_view> optional_keys) const;
    std::vector<JsonReader> array() const;
    /// The keys of an object with their values, in the order of the keys.
    std::vector<std::pair<std::string, JsonReader>> members() const;

    bool is_object() const;
    bool is_array() const;
    bool is_string() const;
    bool is_number() const;

    bool boolean() const;
    double number() const;
    double number_above(double limit) const;
    double number_at_least(double limit) const;
    double number_within(double least, double most) const;
    /// So many numbers.
    std::vector<double> numbers(std::size_t count) const;
    Vec3d vec3() const;
    std::string string() const;
    /// A whole number in that range.
    std::uint64_t integer(std::uint64_t least, std::uint64_t most) const;
    /// A whole number from 0 to count - 1.
    std::size_t index(std::size_t count) const;

    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }

    /// The value whose name this string is, in a table of Named values.
    template <class Table>
    auto choice(const Table& table) const {
        const std::string name = string();
        std::string names;
        for (const auto& [known, value] : table) {
            if (known == name) return value;
            names += (names.empty() ? "" : ", ") + std::string(known);
        }
        fail("one of " + names);
    }

    /// Throws the ParseError that says what was found here, and what was expected instead.
    [[noreturn]] void fail(const std::string& expected) const;

private:
    /// The document and the value in it are those of the JSON library, which stays out of headers.
    JsonReader(std::shared_ptr<const void> document, const void* value, std::string file,
               std::string path)
        : document_(std::move(document)),
          value_(value),
          file_(std::move(file)),
          path_(std::move(path)) {}

    std::shared_ptr<const void> document_;
    const void* value_;
    std::string file_;
    std::string path_;
};

}  // namespace boxwood
