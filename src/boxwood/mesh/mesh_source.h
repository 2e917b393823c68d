// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "boxwood/core/limits.h"

namespace boxwood {

/// How files are read, and what they may ask for.
struct ReadOptions {
    Limits limits = {};
    /// Whether a file may name others that lie outside its own folder.
    bool allow_outside_files = false;
};

/// What a reader reads: the unpacked content of a file. The path is the file's name in messages,
/// and the files it names are looked up beside it.
struct MeshSource {
    std::string_view bytes;
    std::filesystem::path path;

    std::string name() const { return path.string(); }
};

}  // namespace boxwood
