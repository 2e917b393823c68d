// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "boxwood/core/vec.h"

namespace boxwood {

/// From black over violet, red and orange to pale yellow, ever lighter, for values from 0 to 1.
inline Vec3d heat_color(double value) {
    static const std::array<Vec3d, 6> kStops = {Vec3d(0.00, 0.00, 0.02), Vec3d(0.26, 0.05, 0.42),
                                                Vec3d(0.62, 0.13, 0.41), Vec3d(0.91, 0.33, 0.20),
                                                Vec3d(0.99, 0.66, 0.10), Vec3d(0.99, 1.00, 0.72)};
    const double place = std::clamp(value, 0.0, 1.0) * (kStops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(stop);
    return (1 - part) * kStops[stop] + part * kStops[stop + 1];
}

}  // namespace boxwood
