// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/core/named.h"

namespace boxwood {

/// What a picture shows; render/ has a file for each.
enum class IntegratorKind { phong, whitted, normal, depth, heat };

std::span<const Named<IntegratorKind>> integrators();

/// How numbers of light become those of a picture: as they are, as classic scenes demand, or by the
/// curve that screens expect.
enum class ColorEncoding { linear, srgb };

std::span<const Named<ColorEncoding>> color_encodings();

/// How a world wants its picture to be made.
struct PictureSettings {
    int width = 640;
    int height = 480;
    IntegratorKind integrator = IntegratorKind::phong;
    int bounces = 5;
    int samples = 1;  ///< rays a pixel
    std::uint64_t seed = 0;
    ColorEncoding encoding =
        ColorEncoding::linear;  ///< of light; depths and such are never encoded
};

}  // namespace boxwood
