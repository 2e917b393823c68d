// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxwood/image/srgb.h"

namespace boxwood {
namespace {

/// Two by two pixels: black and white above red and half-transparent blue.
Texture four_pixels() {
    Texture texture;
    texture.image = Rgba8Image(2, 2, {});
    texture.image.pixels = {
        {0, 0, 0, 255}, {255, 255, 255, 255}, {255, 0, 0, 255}, {0, 0, 255, 51}};
    return texture;
}

TEST(Texture, shows_its_pixels_at_their_middles) {
    for (const bool is_smooth : {false, true}) {
        Texture texture = four_pixels();
        texture.is_smooth = is_smooth;
        EXPECT_EQ(color_at(texture, {0.25, 0.25}), Eigen::Vector4d(0, 0, 0, 1));
        EXPECT_EQ(color_at(texture, {0.75, 0.25}), Eigen::Vector4d(1, 1, 1, 1));
        EXPECT_EQ(color_at(texture, {0.25, 0.75}), Eigen::Vector4d(1, 0, 0, 1));
        EXPECT_EQ(color_at(texture, {0.75, 0.75}), Eigen::Vector4d(0, 0, 1, 0.2));
    }
}

TEST(Texture, blends_light_and_not_its_encoding) {
    const Texture texture = four_pixels();
    EXPECT_TRUE(color_at(texture, {0.5, 0.25}).isApprox(Eigen::Vector4d(0.5, 0.5, 0.5, 1)));
    EXPECT_TRUE(color_at(texture, {0.5, 0.5}).isApprox(Eigen::Vector4d(0.5, 0.25, 0.5, 0.8)));
}

TEST(Texture, goes_on_beyond_its_edges_as_it_is_told) {
    Texture texture = four_pixels();
    texture.is_smooth = false;
    const auto red_at = [&](double x) { return color_at(texture, {x, 0.25}).x(); };
    texture.wrap_x = TextureWrap::repeat;
    EXPECT_EQ(red_at(1.25), 0);
    EXPECT_EQ(red_at(-0.25), 1);
    EXPECT_EQ(red_at(-7.25), 1);
    texture.wrap_x = TextureWrap::clamp;
    EXPECT_EQ(red_at(1.25), 1);
    EXPECT_EQ(red_at(-0.25), 0);
    texture.wrap_x = TextureWrap::mirror;
    EXPECT_EQ(red_at(1.25), 1);
    EXPECT_EQ(red_at(1.75), 0);
    EXPECT_EQ(red_at(-0.25), 0);
    EXPECT_EQ(red_at(-0.75), 1);
}

TEST(Texture, places_out_of_this_world_are_white_or_somewhere_in_it) {
    const Texture texture = four_pixels();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double x : {kNan, kInfinity, -kInfinity, 1e300})
        EXPECT_EQ(color_at(texture, {x, 0}), Eigen::Vector4d::Ones());
    EXPECT_EQ(color_at({}, {0.5, 0.5}), Eigen::Vector4d::Ones());
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
        Texture wrapped = texture;
        wrapped.wrap_x = wrapped.wrap_y = wrap;
        for (const double x : {-1e11, -1e-17, 0.0, 1.0, 2.0, 1e11})
            EXPECT_TRUE(color_at(wrapped, {x, -x}).allFinite()) << x;
    }
}

TEST(Srgb, is_the_curve_of_the_standard_and_its_inverse) {
    // The standard's own example: 18 % grey.
    EXPECT_NEAR(linear_to_srgb(0.18), 0.4614, 1e-4);
    EXPECT_EQ(linear_to_srgb(-1), 0);
    EXPECT_EQ(linear_to_srgb(7), 1);
    EXPECT_EQ(linear_to_srgb(std::nan("")), 0);
    for (int i = 0; i <= 255; ++i)
        EXPECT_NEAR(linear_to_srgb(srgb_to_linear(i / 255.0)), i / 255.0, 1e-7);
}

}  // namespace
}  // namespace boxwood
