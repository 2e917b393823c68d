// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "boxwood/core/json_reader.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// Where the files that a scene names are looked for.
class DescriptionFiles {
public:
    DescriptionFiles(const std::filesystem::path& scene, std::filesystem::path data_folder,
                     const ReadOptions& options)
        : root_(scene.parent_path()), data_(std::move(data_folder)), options_(options) {}

    const ReadOptions& options() const { return options_; }

    /// The path of the file that a value names, in a file whose folder, seen from the scene's, is
    /// the given one. Throws ParseError when there is none, or when it leads out of the scene's
    /// folder.
    std::filesystem::path find(const JsonReader& name, const std::filesystem::path& folder) const;

private:
    std::filesystem::path root_;
    std::filesystem::path data_;
    ReadOptions options_;
};

}  // namespace boxwood
