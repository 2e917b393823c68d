// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood {

/// What an OFF file says of itself.
struct OffHeader {
    bool has_texture_coordinates = false;
    bool has_colors = false;
    bool has_normals = false;
    bool is_homogeneous = false;
    bool has_dimension = false;
    bool is_binary = false;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t line = 0;  ///< of the counts
};

/// Reads the header, up to what comes after the line of the counts; in a binary file, after that of
/// the keyword, with the counts still unknown. Throws ParseError.
OffHeader read_off_header(TextScanner& scanner, const std::string& file, const Limits& limits);

}  // namespace boxwood
