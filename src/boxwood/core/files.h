// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace boxwood {

/// Whether a file is read from front to back, once, or here and there.
enum class FileAccess { sequential, random };

/// A whole file as read-only memory, mapped where the system can: pages are read when they are
/// touched and shared with other processes. Nobody may shorten the file meanwhile. Move-only.
class MappedFile {
public:
    /// Throws IoError when the path isn't a regular file that can be read.
    explicit MappedFile(const std::filesystem::path& path,
                        FileAccess access = FileAccess::sequential);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;

    std::string_view text() const { return {data_, size_}; }

private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

/// A file that appears whole or not at all: written beside its place under another name, and
/// renamed by commit(). Without commit() nothing is left behind.
class OutputFile {
public:
    /// Throws IoError when the folder can't be written to, or the path is a folder.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Throws IoError, on a full disk for one.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::FILE* file_ = nullptr;
};

}  // namespace boxwood
