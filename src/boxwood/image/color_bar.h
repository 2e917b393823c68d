// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/image/image.h"

namespace boxwood {

/// Draws the scale of heat_color() along the right edge of the picture, with 0, the middle and the
/// largest value written beside it. Pictures too small for it stay as they are.
void draw_color_bar(ColorImage& image, int largest_value);

}  // namespace boxwood
