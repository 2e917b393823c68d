// SPDX-License-Identifier: Apache-2.0
// depth: how far away the surface is, the nearest point of the picture white and the farthest dark
// grey, evenly in between. Where there is no surface it is black.
#include "boxwood/render/depth.h"

#include <algorithm>
#include <limits>

namespace boxwood {

namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kFarthestGrey = 0.1;

}  // namespace

std::vector<Color> DepthIntegrator::radiances(std::span<const Ray> rays) const {
    std::vector<Color> colors;
    colors.reserve(rays.size());
    for (const auto& hit : surfaces_.closest_hits(rays))
        colors.emplace_back(Color::Constant(hit ? hit->t : kNothing));
    return colors;
}

void DepthIntegrator::develop(ColorImage& image) const {
    double nearest = kNothing, farthest = 0;
    for (const Color& pixel : image.pixels) {
        if (pixel.x() == kNothing) continue;
        nearest = std::min(nearest, pixel.x());
        farthest = std::max(farthest, pixel.x());
    }
    for (Color& pixel : image.pixels) {
        const double depth = pixel.x();
        const double part = farthest > nearest ? (depth - nearest) / (farthest - nearest) : 0;
        pixel.setConstant(depth == kNothing ? 0 : 1 - (1 - kFarthestGrey) * part);
    }
}

}  // namespace boxwood
