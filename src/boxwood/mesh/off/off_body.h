// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"
#include "boxwood/mesh/off/off_header.h"

namespace boxwood {

// What follows the header of an OFF file: both throw ParseError.

/// The lines that the scanner stands before.
MeshData read_off_text(const OffHeader& header, const MeshSource& source,
                       const TextScanner& scanner, const Limits& limits);

/// The bytes, which are the last of the source.
MeshData read_off_binary(OffHeader header, const MeshSource& source, std::string_view bytes,
                         const Limits& limits);

}  // namespace boxwood
