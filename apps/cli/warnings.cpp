// SPDX-License-Identifier: Apache-2.0
#include "cli/warnings.h"

#include <fmt/format.h>

namespace boxwood::cli {

void print_warnings(const Warnings& warnings) {
    for (const Warning& warning : warnings.kinds()) {
        for (const std::string& text : warning.shown)
            fmt::print(stderr, "boxwood: warning: {}\n", text);
        if (warning.count > warning.shown.size())
            fmt::print(stderr, "boxwood: warning: ... and {} more: {}\n",
                       warning.count - warning.shown.size(), warning.kind);
    }
}

}  // namespace boxwood::cli
