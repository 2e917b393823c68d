// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <new>

#include "boxwood/core/error.h"

namespace boxwood {

Rgba8Image parse_jpeg(std::string_view bytes, const std::string& name) {
    const auto close = [](void* handle) { tjDestroy(handle); };
    const std::unique_ptr<void, decltype(close)> handle(tjInitDecompress(), close);
    if (!handle) throw std::bad_alloc();
    const auto fail = [&] {
        throw ParseError(name, "",
                         std::string("not a readable JPEG: ") + tjGetErrorStr2(handle.get()));
    };

    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0, height = 0, subsampling = 0, colors = 0;
    if (tjDecompressHeader3(handle.get(), data, bytes.size(), &width, &height, &subsampling,
                            &colors) != 0)
        fail();
    // A header that is cut off may pass for one of no size.
    if (width < 1 || height < 1)
        throw ParseError(name, "", "not a readable JPEG: found no pixels, expected some");
    if (!is_image_size(width, height))
        throw ParseError(name, "", "found a picture beyond 2^28 pixels, expected a smaller one");
    Rgba8Image image(width, height, {});
    if (tjDecompress2(handle.get(), data, bytes.size(),
                      reinterpret_cast<unsigned char*>(image.pixels.data()), width, 0, height,
                      TJPF_RGBA, TJFLAG_STOPONWARNING) != 0)
        fail();
    return image;
}

}  // namespace boxwood
