// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "boxwood/image/image.h"

namespace boxwood {

/// The picture in the content of a JPEG file. The name stands for the file in messages. Throws
/// ParseError, also for a damaged one.
Rgba8Image parse_jpeg(std::string_view bytes, const std::string& name);

}  // namespace boxwood
