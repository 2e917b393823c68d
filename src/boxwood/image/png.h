// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/image/image.h"

namespace boxwood {

/// Writes an 8-bit RGBA PNG, which appears whole or not at all. Throws IoError.
void write_png(const std::filesystem::path& path, const Rgba8Image& image);

/// Throws the IoError that write_png() would throw for this path, if any, and writes nothing: to be
/// asked before a long rendering.
void check_png_path(const std::filesystem::path& path);

/// Reads a PNG of any kind as 8-bit RGBA. Throws IoError, and ParseError when it isn't one.
Rgba8Image read_png(const std::filesystem::path& path);

}  // namespace boxwood
