// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "boxwood/image/image.h"

namespace boxwood {

/// The picture in the content of a PNG or JPEG file of any kind, told apart by their first bytes,
/// as 8-bit RGBA. The name stands for the file in messages. Throws ParseError.
Rgba8Image parse_image(std::string_view bytes, const std::string& name);

}  // namespace boxwood
