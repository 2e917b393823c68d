// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/read_image.h"

#include "boxwood/core/error.h"
#include "boxwood/image/jpeg.h"
#include "boxwood/image/png.h"

namespace boxwood {

Rgba8Image parse_image(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("\x89PNG")) return parse_png(bytes, name);
    if (bytes.starts_with("\xff\xd8")) return parse_jpeg(bytes, name);
    throw ParseError(name, "", "found neither a PNG nor a JPEG, expected one of them");
}

}  // namespace boxwood
