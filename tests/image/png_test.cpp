// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/png.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "boxwood/core/error.h"
#include "laws/random.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

Rgba8Image random_image(int width, int height, std::uint64_t seed) {
    Random random(seed);
    const auto byte = [&] { return static_cast<std::uint8_t>(random.index(256)); };
    Rgba8Image image(width, height, {});
    for (Rgba8& pixel : image.pixels) pixel = {byte(), byte(), byte(), byte()};
    return image;
}

TEST(Png, reads_back_what_was_written) {
    const TempDir dir;
    for (const auto& [width, height] : {std::pair(1, 1), {7, 3}, {1, 200}, {333, 1}, {64, 48}}) {
        const Rgba8Image image = random_image(width, height, 1);
        write_png(dir / "image.png", image);
        const Rgba8Image found = read_png(dir / "image.png");
        ASSERT_EQ(found.width, width);
        ASSERT_EQ(found.height, height);
        EXPECT_EQ(found.pixels, image.pixels);
    }
}

TEST(Png, unwritable_place_is_an_io_error_and_leaves_nothing) {
    const TempDir dir;
    EXPECT_THROW(write_png(dir / "no/such/folder.png", random_image(2, 2, 1)), IoError);
    EXPECT_THROW(write_png(dir.path(), random_image(2, 2, 1)), IoError);
    EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
}

TEST(Png, image_without_pixels_is_refused_and_leaves_nothing) {
    const TempDir dir;
    EXPECT_THROW(write_png(dir / "image.png", Rgba8Image()), InvalidInput);
    EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
}

TEST(Png, what_is_no_png_is_a_parse_error) {
    const TempDir dir;
    EXPECT_THROW(read_png(dir.write("empty.png", "")), ParseError);
    EXPECT_THROW(read_png(dir.write("text.png", "not a picture at all")), ParseError);
    EXPECT_THROW(read_png(dir / "missing.png"), IoError);

    write_png(dir / "whole.png", random_image(40, 40, 1));
    const std::string whole = content_of(dir / "whole.png");
    for (const std::size_t length : {8, 20, 50, 1000})
        EXPECT_THROW(read_png(dir.write("cut.png", whole.substr(0, length))), ParseError) << length;
}

}  // namespace
}  // namespace boxwood
