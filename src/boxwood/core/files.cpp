// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "boxwood/core/error.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

IoError system_error(const fs::path& path) { return {path.string(), std::strerror(errno)}; }

}  // namespace

MappedFile::MappedFile(const fs::path& path, FileAccess access) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) throw system_error(path);
    struct stat status = {};
    const bool is_regular = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    if (!is_regular) {
        close(file);
        throw IoError(path.string(), S_ISDIR(status.st_mode)
                                         ? "found a directory, expected a file"
                                         : "found a device or a pipe, expected a file");
    }
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ > 0) {
        void* memory = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
        const int mapping_error = errno;
        close(file);
        errno = mapping_error;
        if (memory == MAP_FAILED) throw system_error(path);
        if (access == FileAccess::sequential) madvise(memory, size_, MADV_SEQUENTIAL);
        data_ = static_cast<const char*>(memory);
    } else {
        close(file);
    }
}

MappedFile::~MappedFile() {
    if (data_) munmap(const_cast<char*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (fs::is_directory(path_, ignored))
        throw IoError(path_.string(), "found a directory, expected a file to write");
    // The file that a link leads to is replaced, not the link; what isn't a file stays what it is.
    if (fs::is_symlink(path_, ignored) && fs::exists(path_, ignored))
        path_ = fs::canonical(path_, ignored);
    if (fs::exists(path_, ignored)) {
        if (!fs::is_regular_file(path_, ignored))
            throw IoError(path_.string(), "found a device or a pipe, expected a file to write");
        if (access(path_.c_str(), W_OK) != 0) throw system_error(path_);
    }
    temporary_ = path_;
    temporary_ += "." + std::to_string(getpid()) + ".partial";
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (!file_) throw system_error(path_);
}

OutputFile::~OutputFile() {
    if (!file_) return;
    std::fclose(file_);
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void OutputFile::write(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        throw system_error(path_);
}

void OutputFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

void OutputFile::commit() {
    std::error_code error;
    if (std::fclose(std::exchange(file_, nullptr)) != 0) {
        const IoError failure = system_error(path_);
        fs::remove(temporary_, error);
        throw failure;
    }
    fs::rename(temporary_, path_, error);
    if (!error) return;
    const IoError failure(path_.string(), error.message());
    fs::remove(temporary_, error);
    throw failure;
}

}  // namespace boxwood
