// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/world/parse_json.h"

namespace boxwood {

using nlohmann::json;

JsonReader::JsonReader(std::shared_ptr<const json> document, const json* value, std::string file,
                       std::string path)
    : document_(std::move(document)),
      value_(value),
      file_(std::move(file)),
      path_(std::move(path)) {}

JsonReader JsonReader::read_file(const std::filesystem::path& path) {
    const MappedFile file(path);
    auto document = std::make_shared<const json>(parse_json(file.text(), path.string()));
    return {document, document.get(), path.string(), "$"};
}

JsonReader JsonReader::operator[](const std::string& key) const {
    if (!value_->is_object()) fail("an object");
    const auto found = value_->find(key);
    if (found == value_->end()) fail(fmt::format("key '{}'", key));
    return {document_, &*found, file_, path_ + "." + key};
}

void JsonReader::expect_keys(std::initializer_list<std::string_view> keys) const {
    if (!value_->is_object()) fail("an object");
    for (const auto& [key, value] : value_->items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            throw ParseError(file_, path_,
                             fmt::format("found unknown key {}, expected {}", description(key),
                                         fmt::join(keys, ", ")));
    }
    for (const std::string_view key : keys) {
        if (!value_->contains(key))
            throw ParseError(file_, path_, fmt::format("found no key '{}', expected one", key));
    }
}

std::vector<JsonReader> JsonReader::array() const {
    if (!value_->is_array()) fail("an array");
    std::vector<JsonReader> items;
    for (std::size_t i = 0; i < value_->size(); ++i)
        items.push_back({document_, &(*value_)[i], file_, fmt::format("{}[{}]", path_, i)});
    return items;
}

bool JsonReader::boolean() const {
    if (!value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
}

double JsonReader::number() const {
    if (!value_->is_number()) fail("a number");
    return value_->get<double>();
}

double JsonReader::number_above(double limit) const {
    if (!(value_->is_number() && number() > limit)) fail(fmt::format("a number above {}", limit));
    return number();
}

double JsonReader::number_at_least(double limit) const {
    if (!(value_->is_number() && number() >= limit))
        fail(fmt::format("a number of at least {}", limit));
    return number();
}

Vec3d JsonReader::vec3() const {
    if (!value_->is_array() || value_->size() != 3) fail("an array of 3 numbers");
    const std::vector<JsonReader> items = array();
    return {items[0].number(), items[1].number(), items[2].number()};
}

std::string JsonReader::string() const {
    if (!value_->is_string()) fail("a string");
    return value_->get<std::string>();
}

std::size_t JsonReader::index(std::size_t count) const {
    const bool in_range = value_->is_number_integer() && *value_ >= 0 && *value_ < count;
    if (!in_range)
        fail(count > 0 ? fmt::format("a whole number from 0 to {}", count - 1)
                       : "nothing, as there is nothing to choose from");
    return value_->get<std::size_t>();
}

void JsonReader::fail(const std::string& expected) const {
    throw ParseError(file_, path_,
                     fmt::format("found {}, expected {}", description(*value_), expected));
}

}  // namespace boxwood
