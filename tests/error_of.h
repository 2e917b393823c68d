// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "boxwood/core/error.h"

namespace boxwood {

/// What the action throws, by type and message.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const ParseError& error) {
        return std::string("ParseError ") + error.what();
    } catch (const InvalidInput& error) {
        return std::string("InvalidInput ") + error.what();
    } catch (const IoError& error) {
        return std::string("IoError ") + error.what();
    }
    return "no error";
}

}  // namespace boxwood
