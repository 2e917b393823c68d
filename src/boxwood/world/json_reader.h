// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/vec.h"

namespace boxwood {

/// A value in a JSON file that knows its place, so that whatever is wrong with it is reported as
/// "file:$.Path.To[3].It: found ..., expected ...". Every function throws ParseError.
class JsonReader {
public:
    /// Reads a whole file. Throws IoError, and ParseError as parse_json() does.
    static JsonReader read_file(const std::filesystem::path& path);

    /// The value of a key of an object.
    JsonReader operator[](const std::string& key) const;
    /// Demands an object with exactly these keys.
    void expect_keys(std::initializer_list<std::string_view> keys) const;
    std::vector<JsonReader> array() const;

    bool boolean() const;
    double number() const;
    double number_above(double limit) const;
    double number_at_least(double limit) const;
    Vec3d vec3() const;
    std::string string() const;
    /// A whole number from 0 to count - 1.
    std::size_t index(std::size_t count) const;

    /// Throws the ParseError that says what was found here, and what was expected instead.
    [[noreturn]] void fail(const std::string& expected) const;

private:
    JsonReader(std::shared_ptr<const nlohmann::json> document, const nlohmann::json* value,
               std::string file, std::string path);

    std::shared_ptr<const nlohmann::json> document_;
    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace boxwood
