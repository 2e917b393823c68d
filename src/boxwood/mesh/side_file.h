// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace boxwood {

/// Why a file may not name that other one, if so: names with a scheme such as http:, absolute paths
/// and paths that lead out of the folder, over ".." or links, are refused unless they are allowed.
/// Nothing is ever fetched or run.
std::optional<std::string> refusal_of(const std::filesystem::path& folder, const std::string& name,
                                      bool allow_outside);

/// "a b" of "a%20b", as URIs are written.
std::string percent_decoded(std::string_view uri);

}  // namespace boxwood
