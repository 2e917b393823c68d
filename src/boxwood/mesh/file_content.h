// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "boxwood/core/files.h"
#include "boxwood/core/limits.h"

namespace boxwood {

/// What gzip packed, all of its members. The name stands for the file in messages. Throws
/// ParseError when the data is damaged or would become more than max_bytes.
std::string unpack_gzip(std::string_view packed, const std::string& name, std::uint64_t max_bytes);

/// The content of a file in memory: mapped, or unpacked when gzip packed it, as its first bytes
/// tell.
class FileContent {
public:
    /// Throws IoError, ParseError when a packed file is damaged or the content is beyond
    /// limits.max_bytes.
    FileContent(const std::filesystem::path& path, const Limits& limits);

    std::string_view bytes() const { return is_packed_ ? unpacked_ : file_.text(); }

private:
    MappedFile file_;
    bool is_packed_ = false;
    std::string unpacked_;
};

}  // namespace boxwood
