// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/jpeg.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "boxwood/image/png.h"
#include "boxwood/image/read_image.h"
#include "error_of.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

/// Colours that change slowly, as JPEG likes them.
Rgba8Image gradient(int width, int height) {
    Rgba8Image image(width, height, {});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(x * 255 / width),
                              static_cast<std::uint8_t>(y * 255 / height), 128, 255};
    }
    return image;
}

std::string jpeg_of(const Rgba8Image& image, int subsampling, int flags = 0) {
    const tjhandle handle = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(
        tjCompress2(handle, reinterpret_cast<const unsigned char*>(image.pixels.data()),
                    image.width, 0, image.height, TJPF_RGBA, &bytes, &size, subsampling, 95, flags),
        0);
    const std::string result(reinterpret_cast<const char*>(bytes), size);
    tjFree(bytes);
    tjDestroy(handle);
    return result;
}

TEST(Jpeg, colours_are_those_that_were_packed_but_for_a_little) {
    const Rgba8Image image = gradient(61, 43);
    for (const auto& [subsampling, flags] :
         {std::pair(TJSAMP_444, 0), {TJSAMP_420, 0}, {TJSAMP_444, TJFLAG_PROGRESSIVE}}) {
        const Rgba8Image found = parse_image(jpeg_of(image, subsampling, flags), "a.jpg");
        ASSERT_EQ(found.width, 61);
        ASSERT_EQ(found.height, 43);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            EXPECT_LE(std::abs(found.pixels[i].r - image.pixels[i].r), 12) << i;
            EXPECT_LE(std::abs(found.pixels[i].g - image.pixels[i].g), 12) << i;
            EXPECT_EQ(found.pixels[i].a, 255);
        }
    }
}

TEST(Jpeg, cut_files_are_an_error) {
    const std::string whole = jpeg_of(gradient(40, 40), TJSAMP_444);
    for (std::size_t size = 0; size + 2 < whole.size(); size += 7)
        EXPECT_TRUE(error_of([&] {
                        parse_jpeg(whole.substr(0, size), "a.jpg");
                    }).starts_with("ParseError a.jpg: not a readable JPEG: "))
            << size;
}

TEST(ReadImage, tells_formats_by_their_first_bytes) {
    const TempDir dir;
    const Rgba8Image image = gradient(5, 4);
    write_png(dir / "a.png", image);
    EXPECT_EQ(parse_image(content_of(dir / "a.png"), "picture").pixels, image.pixels);
    for (const char* bytes : {"", "GIF89a", "\x89", "RIFF"})
        EXPECT_EQ(error_of([&] { parse_image(bytes, "picture"); }),
                  "ParseError picture: found neither a PNG nor a JPEG, expected one of them");
}

}  // namespace
}  // namespace boxwood
