// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "boxwood/core/error.h"
#include "boxwood/core/named.h"

namespace boxwood::python {

/// The value that an argument names. Throws InvalidInput with the names there are.
template <class Value>
Value choice(const char* argument, std::span<const Named<Value>> choices, const std::string& name) {
    if (const auto* found = find_named(choices, name)) return found->value;
    std::string known;
    for (const auto& each : choices)
        known += (known.empty() ? "'" : ", '") + std::string(each.name) + "'";
    throw InvalidInput(std::string(argument) + ": found '" + name + "', expected one of " + known);
}

}  // namespace boxwood::python
