// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace boxwood {

/// A new empty folder that is gone, with all that is in it, when the test is over.
class TempDir {
public:
    TempDir() {
        static std::atomic<int> count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("boxwood-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
        // What a killed test with the same process id may have left behind.
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~TempDir() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// The path of a file in the folder, whether there is one or not.
    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

    /// Writes a file, byte by byte as given, and returns its path.
    std::filesystem::path write(std::string_view name, std::string_view content) const {
        std::ofstream file(path_ / name, std::ios::binary);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        if (!file.flush()) throw std::runtime_error("can't write " + (path_ / name).string());
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

/// All bytes of a file.
inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("can't read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace boxwood
