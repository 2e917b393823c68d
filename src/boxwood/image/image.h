// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxwood/core/vec.h"

namespace boxwood {

/// Pixels in rows from the top, each row from the left.
template <class Pixel>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    Image(int w, int h, const Pixel& pixel)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, pixel) {}

    Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Whether there can be a picture of that size: at least one pixel, at most 2^28 of them, which is
/// what PNG files and the memory of ordinary machines hold.
constexpr bool is_image_size(int width, int height) {
    return width > 0 && height > 0 && std::int64_t{width} * height <= (std::int64_t{1} << 28);
}

struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;

    friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// Linear colour, unbounded.
using ColorImage = Image<Vec3d>;
using Rgba8Image = Image<Rgba8>;

/// round(clamp(c, 0, 1) * 255) for each channel, opaque, no gamma; NaN becomes 0.
inline Rgba8 to_rgba8(const Vec3d& color) {
    const auto channel = [](double c) {
        return static_cast<std::uint8_t>(std::round((c > 0 ? (c < 1 ? c : 1) : 0) * 255));
    };
    return {channel(color.x()), channel(color.y()), channel(color.z()), 255};
}

inline Rgba8Image to_rgba8(const ColorImage& image) {
    Rgba8Image result(image.width, image.height, {});
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        result.pixels[i] = to_rgba8(image.pixels[i]);
    return result;
}

}  // namespace boxwood
