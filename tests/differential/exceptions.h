// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace boxwood {

/// How the comparison of a file of data/ with assimp begins: "same", or for the exceptions what
/// differs.
std::string_view expected_difference(std::string_view file);

}  // namespace boxwood
