// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace boxwood::bench {

/// A mesh that somebody has read, in memory of their own kind.
struct FileInMemory {
    std::shared_ptr<const void> content;
    std::size_t triangles = 0;
};

/// Somebody who reads files. Throws what derives from std::exception.
struct FileReader {
    std::string name;
    int threads;  ///< 0: all there are
    bool (*reads)(std::string_view extension);
    FileInMemory (*read)(const std::filesystem::path& file);
};

/// Boxwood with all threads and with one, and the libraries that were found when this was built.
std::vector<FileReader> file_readers();

// Of the libraries; each in a file of its own.
FileInMemory read_by_assimp(const std::filesystem::path& file);
FileInMemory read_by_tinyobjloader(const std::filesystem::path& file);

}  // namespace boxwood::bench
