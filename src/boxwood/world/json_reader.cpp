// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"

namespace boxwood {

using nlohmann::json;

namespace {

std::size_t line_of(std::string_view text, std::size_t byte) {
    return 1 + std::count(text.begin(), text.begin() + std::min(byte, text.size()), '\n');
}

/// A value as a reader of the message would recognise it.
std::string description(const json& value) {
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > 40) text = text.substr(0, 37) + "...";
    return text;
}

/// JSON's own rule leaves open which of two equal keys counts, so neither does.
class KeysOnce {
public:
    bool operator()(int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) {
            keys_.emplace_back();
        } else if (event == json::parse_event_t::object_end) {
            keys_.pop_back();
        } else if (event == json::parse_event_t::key && !keys_.back().insert(parsed).second) {
            repeated_ = parsed.get<std::string>();
        }
        return true;
    }
    const std::string& repeated() const { return repeated_; }

private:
    std::vector<std::set<std::string>> keys_;
    std::string repeated_;
};

}  // namespace

JsonReader::JsonReader(std::shared_ptr<const json> document, const json* value, std::string file,
                       std::string path)
    : document_(std::move(document)),
      value_(value),
      file_(std::move(file)),
      path_(std::move(path)) {}

JsonReader JsonReader::read_file(const std::filesystem::path& path) {
    const MappedFile file(path);
    const std::string_view text = file.text();
    KeysOnce keys;
    try {
        auto document =
            std::make_shared<const json>(json::parse(text.begin(), text.end(), std::ref(keys)));
        if (!keys.repeated().empty())
            throw ParseError(path.string(), "",
                             fmt::format("found key '{}' twice in one object", keys.repeated()));
        return {document, document.get(), path.string(), "$"};
    } catch (const json::parse_error& error) {
        const std::string what = error.what();
        const std::size_t reason = what.find("syntax error");
        throw ParseError(path.string(), line_of(text, error.byte),
                         reason == std::string::npos ? what : what.substr(reason));
    } catch (const json::out_of_range& error) {
        throw ParseError(path.string(), "", "found a number too large for double precision");
    }
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
            throw ParseError(
                file_, path_,
                fmt::format("found unknown key '{}', expected {}", key, fmt::join(keys, ", ")));
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
