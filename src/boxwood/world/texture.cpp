// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxwood/image/srgb.h"

namespace boxwood {

namespace {

/// The pixel that a whole number stands for, whatever it is.
int wrapped(double place, int size, TextureWrap wrap) {
    const double n = size;
    switch (wrap) {
        case TextureWrap::clamp:
            return static_cast<int>(std::clamp(place, 0.0, n - 1));
        case TextureWrap::repeat:
            return std::min(static_cast<int>(place - n * std::floor(place / n)), size - 1);
        case TextureWrap::mirror: {
            const double in_pair = place - 2 * n * std::floor(place / (2 * n));
            return std::clamp(static_cast<int>(in_pair < n ? in_pair : 2 * n - 1 - in_pair), 0,
                              size - 1);
        }
    }
    return 0;
}

Eigen::Vector4d linear_color(const Rgba8& pixel) {
    static const std::array<double, 256> kLinear = [] {
        std::array<double, 256> table = {};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = srgb_to_linear(static_cast<double>(i) / 255);
        return table;
    }();
    return {kLinear[pixel.r], kLinear[pixel.g], kLinear[pixel.b], pixel.a / 255.0};
}

}  // namespace

Eigen::Vector4d color_at(const Texture& texture, const Vec2d& place) {
    const Rgba8Image& image = texture.image;
    // Beyond this, whole numbers are all that doubles tell apart.
    constexpr double kFarthest = 0x1p40;
    if (image.pixels.empty() || !(place.lpNorm<Eigen::Infinity>() < kFarthest))
        return Eigen::Vector4d::Ones();
    const auto pixel = [&](double x, double y) {
        return linear_color(image.at(wrapped(x, image.width, texture.wrap_x),
                                     wrapped(y, image.height, texture.wrap_y)));
    };
    const double x = place.x() * image.width, y = place.y() * image.height;
    if (!texture.is_smooth) return pixel(std::floor(x), std::floor(y));
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double right_part = x - 0.5 - left, bottom_part = y - 0.5 - top;
    return (1 - bottom_part) *
               ((1 - right_part) * pixel(left, top) + right_part * pixel(left + 1, top)) +
           bottom_part *
               ((1 - right_part) * pixel(left, top + 1) + right_part * pixel(left + 1, top + 1));
}

}  // namespace boxwood
