// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/png.h"

#include <png.h>

#include <string>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"

namespace boxwood {

std::string encode_png(const Rgba8Image& image) {
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGBA;
    // The image is small and the disk is quick: fast compression costs a few kilobytes.
    header.flags = PNG_IMAGE_FLAG_FAST;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0,
                                   nullptr))
        throw InvalidInput(std::string("the picture can't be written as PNG: ") + header.message);
    bytes.resize(size);
    return bytes;
}

void write_png(const std::filesystem::path& path, const Rgba8Image& image) {
    OutputFile file(path);
    file.write(encode_png(image));
    file.commit();
}

void check_png_path(const std::filesystem::path& path) { const OutputFile trial(path); }

Rgba8Image read_png(const std::filesystem::path& path) {
    const MappedFile file(path);
    return parse_png(file.text(), path.string());
}

Rgba8Image parse_png(std::string_view bytes, const std::string& name) {
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    const auto fail = [&] {
        const std::string message = header.message;
        png_image_free(&header);
        throw ParseError(name, "", "not a readable PNG: " + message);
    };
    if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size())) fail();
    header.format = PNG_FORMAT_RGBA;
    if (header.width > 1 << 28 || header.height > 1 << 28 ||
        !is_image_size(static_cast<int>(header.width), static_cast<int>(header.height))) {
        png_image_free(&header);
        throw ParseError(name, "", "found a picture beyond 2^28 pixels, expected a smaller one");
    }
    Rgba8Image image(static_cast<int>(header.width), static_cast<int>(header.height), {});
    if (!png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr)) fail();
    return image;
}

}  // namespace boxwood
