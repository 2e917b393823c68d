// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace boxwood {

/// The text of a file as a JSON document. Throws ParseError with the line, what was found there and
/// what was expected when it isn't JSON, when a key stands twice in one object, and when a number
/// is too large for a double.
nlohmann::json parse_json(std::string_view text, const std::string& file);

/// A value as a reader of a message would recognise it: short, on one line, in ASCII.
std::string description(const nlohmann::json& value);

}  // namespace boxwood
