// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "boxwood/image/image.h"

namespace boxwood {

/// The bytes of an 8-bit RGBA PNG file. Throws InvalidInput where there can't be one.
std::string encode_png(const Rgba8Image& image);

/// Writes such a file, which appears whole or not at all. Throws IoError, too.
void write_png(const std::filesystem::path& path, const Rgba8Image& image);

/// Throws the IoError that write_png() would throw for this path, if any, and writes nothing: to be
/// asked before a long rendering.
void check_png_path(const std::filesystem::path& path);

/// The picture in the content of a PNG file of any kind, as 8-bit RGBA. The name stands for the
/// file in messages. Throws ParseError.
Rgba8Image parse_png(std::string_view bytes, const std::string& name);

/// The same for a file. Throws IoError, too.
Rgba8Image read_png(const std::filesystem::path& path);

}  // namespace boxwood
