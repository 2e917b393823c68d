// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/error.h"
#include "mesh/parse.h"

namespace boxwood {

/// A file that isn't as it should be, and all that is said of it.
struct BadFile {
    std::string bytes;
    std::string verdict;
};

/// What a reader says of a file: the message of its error, or else its warnings as
/// "KIND (COUNT): FIRST MESSAGE", parted by "; ", or "fine". The file's name is left out.
inline std::string verdict_on(Parse parse, std::string_view bytes,
                              const ReadOptions& options = {}) {
    const std::string name = "mesh:";
    const auto without_name = [&](std::string text) {
        return text.starts_with(name) ? text.substr(text.find_first_not_of(' ', name.size()))
                                      : text;
    };
    try {
        const MeshData mesh = parse({bytes, "mesh"}, options);
        check_indices(mesh);
        check_attributes(mesh, mesh.attributes);
        std::string result;
        for (const Warning& warning : mesh.warnings.kinds())
            result += (result.empty() ? "" : "; ") + warning.kind + " (" +
                      std::to_string(warning.count) + "): " + without_name(warning.shown.at(0));
        return result.empty() ? "fine" : result;
    } catch (const ParseError& error) {
        return without_name(error.what());
    }
}

}  // namespace boxwood
