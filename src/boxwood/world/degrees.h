// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace boxwood {

inline double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

/// An angle for which radians() gives just this back, or nearly where there is none.
inline double degrees(double radians_wanted) {
    const double nearest = radians_wanted * (180 / std::numbers::pi);
    double below = nearest, above = nearest;
    for (int i = 0; i < 4; ++i) {
        if (radians(below) == radians_wanted) return below;
        if (radians(above) == radians_wanted) return above;
        below = std::nextafter(below, -std::numeric_limits<double>::infinity());
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
    }
    return nearest;
}

}  // namespace boxwood
