// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "boxwood/core/limits.h"

namespace boxwood {

/// The text of a file as a JSON document. Throws ParseError with the line, what was found there and
/// what was expected when it isn't JSON, when a key stands twice in one object, when a number is
/// too large for a double, and when values lie in more than max_depth others.
nlohmann::json parse_json(std::string_view text, const std::string& file,
                          std::uint64_t max_depth = Limits().max_depth);

/// A value as a reader of a message would recognise it: short, on one line, in ASCII.
std::string description(const nlohmann::json& value);

}  // namespace boxwood
