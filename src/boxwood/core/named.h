// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace boxwood {

/// One line of a table of choices: what a user calls it and what it is.
template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

/// The choice of that name, or null.
template <class Value>
const Named<Value>* find_named(std::span<const Named<Value>> choices, std::string_view name) {
    for (const Named<Value>& choice : choices) {
        if (choice.name == name) return &choice;
    }
    return nullptr;
}

/// The name of a value that stands in the table.
template <class Value>
std::string_view name_of(std::span<const Named<Value>> choices, const Value& value) {
    for (const Named<Value>& choice : choices) {
        if (choice.value == value) return choice.name;
    }
    return {};
}

}  // namespace boxwood
