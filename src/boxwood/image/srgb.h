// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace boxwood {

// The curve of IEC 61966-2-1, by which screens show numbers from 0 to 1. NaN becomes 0.

inline double linear_to_srgb(double c) {
    if (!(c > 0)) return 0;
    if (c >= 1) return 1;
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

inline double srgb_to_linear(double c) {
    if (!(c > 0)) return 0;
    if (c >= 1) return 1;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace boxwood
