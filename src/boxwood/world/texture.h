// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/vec.h"
#include "boxwood/image/image.h"

namespace boxwood {

/// What is beyond the edges of a picture.
enum class TextureWrap { repeat, mirror, clamp };

/// A picture that covers surfaces, its colors encoded as sRGB.
struct Texture {
    Rgba8Image image;
    TextureWrap wrap_x = TextureWrap::repeat;
    TextureWrap wrap_y = TextureWrap::repeat;
    bool is_smooth = true;  ///< blends neighbouring pixels
};

/// Linear red, green and blue, and alpha, at a place counted in widths and heights from the upper
/// left corner. White where the place isn't finite or there is no picture.
Eigen::Vector4d color_at(const Texture& texture, const Vec2d& place);

}  // namespace boxwood
