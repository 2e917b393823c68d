// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "boxwood/core/warnings.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// The files as assimp sees them: the one that is read, from memory, and beside it those that it
/// may name. There are no others, and none to write.
class AssimpFiles : public Assimp::IOSystem {
public:
    /// Both are kept by reference.
    AssimpFiles(const MeshSource& source, const ReadOptions& options)
        : source_(source), options_(options) {}

    /// What assimp calls the file that is read.
    std::string main_file() const;
    /// Of files that were asked for and refused.
    const Warnings& warnings() const { return warnings_; }

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    /// Tells of a file that may not be opened, once.
    bool may_open(const std::string& name) const;
    /// Null for a file that isn't there or may not be opened.
    const FileContent* side_file(const std::string& name);

    const MeshSource& source_;
    const ReadOptions& options_;
    std::map<std::string, std::unique_ptr<const FileContent>> side_files_;
    mutable std::set<std::string> refused_;
    mutable Warnings warnings_;  ///< asking whether a file exists is const
};

}  // namespace boxwood
