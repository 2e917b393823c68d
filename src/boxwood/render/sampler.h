// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "boxwood/core/random.h"
#include "boxwood/world/camera.h"

namespace boxwood {

/// Where the rays of a pixel go: Roberts' additive sequence in four dimensions, which fills the
/// square of the pixel and that of the lens evenly however many samples there are, shifted by a
/// random vector for each pixel. Any sample is known from its number, so work can be split anyhow.
/// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
inline CameraSample camera_sample(std::uint64_t seed, std::uint64_t pixel, int sample,
                                  double spread, int x, int y) {
    constexpr double kRoot = 1.1673039782614187;  // of g^5 = g + 1
    const auto place = [&](std::uint32_t dimension) {
        const double step = std::pow(kRoot, -static_cast<double>(dimension + 1));
        const double value = uniform(seed, pixel, dimension) + sample * step;
        return value - std::floor(value);
    };
    return {.film = {x + 0.5 + spread * (place(0) - 0.5), y + 0.5 + spread * (place(1) - 0.5)},
            .lens = {place(2), place(3)}};
}

}  // namespace boxwood
