// SPDX-License-Identifier: Apache-2.0
#include "boxwood/image/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/image/color_bar.h"
#include "boxwood/image/color_map.h"

namespace boxwood {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int channel(double value) { return to_rgba8(Vec3d(value, 0, 0)).r; }

TEST(ToRgba8, rounds_to_the_nearest_of_256_steps) {
    EXPECT_EQ(channel(0), 0);
    EXPECT_EQ(channel(1), 255);
    EXPECT_EQ(channel(0.5), 128);  // 127.5 goes up
    EXPECT_EQ(channel(0.3), 77);   // 76.5 in decimals, a little less in double
    EXPECT_EQ(channel(0.9), 230);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(channel(i / 255.0), i);
    EXPECT_EQ(channel(0.499 / 255), 0);
    EXPECT_EQ(channel(0.501 / 255), 1);
}

TEST(ToRgba8, clamps_and_is_0_for_nan) {
    EXPECT_EQ(channel(-0.1), 0);
    EXPECT_EQ(channel(-kInfinity), 0);
    EXPECT_EQ(channel(1.1), 255);
    EXPECT_EQ(channel(1e300), 255);
    EXPECT_EQ(channel(kInfinity), 255);
    EXPECT_EQ(channel(std::nan("")), 0);
}

TEST(ToRgba8, keeps_channels_apart_and_is_opaque) {
    EXPECT_EQ(to_rgba8(Vec3d(1, 0.2, 0)), (Rgba8{255, 51, 0, 255}));
}

TEST(Image, pixels_are_in_rows_from_the_top) {
    ColorImage image(3, 2, Vec3d::Zero());
    image.at(2, 0) = Vec3d(1, 0, 0);
    image.at(0, 1) = Vec3d(0, 1, 0);
    EXPECT_EQ(image.pixels[2], Vec3d(1, 0, 0));
    EXPECT_EQ(image.pixels[3], Vec3d(0, 1, 0));
    const Rgba8Image converted = to_rgba8(image);
    EXPECT_EQ(converted.width, 3);
    EXPECT_EQ(converted.height, 2);
    EXPECT_EQ(converted.at(2, 0), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(converted.at(0, 1), (Rgba8{0, 255, 0, 255}));
}

TEST(Image, size_is_one_of_a_picture_from_1_to_2_to_the_28_pixels) {
    for (const auto& [width, height] :
         {std::pair(1, 1), {640, 480}, {1 << 14, 1 << 14}, {1 << 28, 1}})
        EXPECT_TRUE(is_image_size(width, height)) << width << "x" << height;
    constexpr int kMost = std::numeric_limits<int>::max();
    for (const auto& [width, height] :
         {std::pair(0, 1), {1, 0}, {-1, -1}, {(1 << 28) + 1, 1}, {16'385, 16'384}, {kMost, kMost}})
        EXPECT_FALSE(is_image_size(width, height)) << width << "x" << height;
}

TEST(ColorMap, grows_ever_lighter) {
    double luminance = -1;
    for (int i = 0; i <= 1000; ++i) {
        const double lighter = heat_color(i / 1000.0).dot(Vec3d(0.2126, 0.7152, 0.0722));
        EXPECT_GT(lighter, luminance) << i;
        luminance = lighter;
    }
    EXPECT_EQ(heat_color(-1), heat_color(0));
    EXPECT_EQ(heat_color(2), heat_color(1));
}

TEST(ColorBar, stays_at_the_right_edge_and_is_brightest_on_top) {
    const Vec3d gray = Vec3d::Constant(0.123);
    ColorImage image(640, 480, gray);
    draw_color_bar(image, 12'345);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width / 2; ++x) ASSERT_EQ(image.at(x, y), gray);
    }
    EXPECT_NE(image.pixels, ColorImage(640, 480, gray).pixels);
}

TEST(ColorBar, small_pictures_stay_as_they_are) {
    const Vec3d gray = Vec3d::Constant(0.123);
    for (int size = 1; size <= 12; ++size) {
        ColorImage image(size, size, gray);
        draw_color_bar(image, 100);
        EXPECT_EQ(image.pixels, ColorImage(size, size, gray).pixels) << size;
    }
    // Sizes about the border, and numbers of any length, stay within the picture.
    for (int width = 1; width < 120; width += 3) {
        for (int height = 1; height < 120; height += 3) {
            for (const int largest : {0, 1, 2'000'000'000}) {
                ColorImage image(width, height, gray);
                draw_color_bar(image, largest);
            }
        }
    }
}

}  // namespace
}  // namespace boxwood
