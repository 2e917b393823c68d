// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/parse_json.h"

namespace boxwood {

using nlohmann::json;

namespace {

const json& value_of(const void* value) { return *static_cast<const json*>(value); }

}  // namespace

JsonReader JsonReader::parse(std::string_view text, const std::string& file, const Limits& limits) {
    auto document = std::make_shared<const json>(parse_json(text, file, limits.max_depth));
    return {document, document.get(), file, "$"};
}

JsonReader JsonReader::operator[](const std::string& key) const {
    if (auto found = find(key)) return *std::move(found);
    fail(fmt::format("key '{}'", key));
}

std::optional<JsonReader> JsonReader::find(const std::string& key) const {
    if (!value_of(value_).is_object()) fail("an object");
    const auto found = value_of(value_).find(key);
    if (found == value_of(value_).end()) return std::nullopt;
    return JsonReader(document_, &*found, file_, path_ + "." + key);
}

void JsonReader::expect_keys(std::initializer_list<std::string_view> keys,
                             std::initializer_list<std::string_view> optional_keys) const {
    if (!value_of(value_).is_object()) fail("an object");
    std::vector<std::string_view> known(keys);
    known.insert(known.end(), optional_keys);
    for (const auto& [key, value] : value_of(value_).items()) {
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw ParseError(file_, path_,
                             fmt::format("found unknown key {}, expected {}", description(key),
                                         fmt::join(known, ", ")));
    }
    for (const std::string_view key : keys) {
        if (!value_of(value_).contains(key))
            throw ParseError(file_, path_, fmt::format("found no key '{}', expected one", key));
    }
}

std::vector<JsonReader> JsonReader::array() const {
    if (!value_of(value_).is_array()) fail("an array");
    std::vector<JsonReader> items;
    for (std::size_t i = 0; i < value_of(value_).size(); ++i)
        items.push_back({document_, &value_of(value_)[i], file_, fmt::format("{}[{}]", path_, i)});
    return items;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    if (!value_of(value_).is_object()) fail("an object");
    std::vector<std::pair<std::string, JsonReader>> result;
    for (const auto& [key, value] : value_of(value_).items())
        result.emplace_back(key, JsonReader(document_, &value, file_, path_ + "." + key));
    return result;
}

bool JsonReader::is_object() const { return value_of(value_).is_object(); }
bool JsonReader::is_array() const { return value_of(value_).is_array(); }
bool JsonReader::is_string() const { return value_of(value_).is_string(); }
bool JsonReader::is_number() const { return value_of(value_).is_number(); }

bool JsonReader::boolean() const {
    if (!value_of(value_).is_boolean()) fail("true or false");
    return value_of(value_).get<bool>();
}

double JsonReader::number() const {
    if (!value_of(value_).is_number()) fail("a number");
    return value_of(value_).get<double>();
}

double JsonReader::number_above(double limit) const {
    if (!(value_of(value_).is_number() && number() > limit))
        fail(fmt::format("a number above {}", limit));
    return number();
}

double JsonReader::number_at_least(double limit) const {
    if (!(value_of(value_).is_number() && number() >= limit))
        fail(fmt::format("a number of at least {}", limit));
    return number();
}

double JsonReader::number_within(double least, double most) const {
    if (!(value_of(value_).is_number() && number() >= least && number() <= most))
        fail(fmt::format("a number from {} to {}", least, most));
    return number();
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
    if (!value_of(value_).is_array() || value_of(value_).size() != count)
        fail(fmt::format("an array of {} numbers", count));
    std::vector<double> result;
    for (const JsonReader& item : array()) result.push_back(item.number());
    return result;
}

Vec3d JsonReader::vec3() const {
    const std::vector<double> all = numbers(3);
    return {all[0], all[1], all[2]};
}

std::string JsonReader::string() const {
    if (!value_of(value_).is_string()) fail("a string");
    return value_of(value_).get<std::string>();
}

std::uint64_t JsonReader::integer(std::uint64_t least, std::uint64_t most) const {
    const bool in_range = value_of(value_).is_number_integer() && value_of(value_) >= 0 &&
                          value_of(value_) >= least && value_of(value_) <= most;
    if (!in_range) fail(fmt::format("a whole number from {} to {}", least, most));
    return value_of(value_).get<std::uint64_t>();
}

std::size_t JsonReader::index(std::size_t count) const {
    const bool in_range =
        value_of(value_).is_number_integer() && value_of(value_) >= 0 && value_of(value_) < count;
    if (!in_range)
        fail(count > 0 ? fmt::format("a whole number from 0 to {}", count - 1)
                       : "nothing, as there is nothing to choose from");
    return value_of(value_).get<std::size_t>();
}

void JsonReader::fail(const std::string& expected) const {
    throw ParseError(file_, path_,
                     fmt::format("found {}, expected {}", description(value_of(value_)), expected));
}

}  // namespace boxwood
