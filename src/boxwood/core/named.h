// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace boxwood {

/// One line of a table of choices: what a user calls it and what it is.
template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

}  // namespace boxwood
