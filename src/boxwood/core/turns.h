// SPDX-License-Identifier: Apache-2.0
// Sine and cosine of angles counted in full turns, the same to the last bit on every machine, which
// the C library's are not: generated meshes must not depend on it. Taylor series after reduction to
// an eighth of a turn; the error is below 4e-16.
#pragma once

#include <cmath>

namespace boxwood {

/// sin(2 pi x), exact at multiples of a quarter. Precondition: |x| < 1e9.
inline double sin_turns(double x) {
    const double in_turn = x - std::floor(x + 0.5);
    const double quarter = std::floor(4 * in_turn + 0.5);
    const double a = 6.283185307179586 * (in_turn - quarter / 4);
    const double q = a * a;
    const double sine =
        a -
        a * q *
            (1 -
             q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110 * (1 - q / 156 * (1 - q / 210)))))) /
            6;
    const double cosine =
        1 -
        q / 2 *
            (1 -
             q / 12 *
                 (1 -
                  q / 30 *
                      (1 - q / 56 * (1 - q / 90 * (1 - q / 132 * (1 - q / 182 * (1 - q / 240)))))));
    switch (static_cast<int>(quarter) & 3) {
        case 0:
            return sine;
        case 1:
            return cosine;
        case 2:
            return -sine;
        default:
            return -cosine;
    }
}

/// cos(2 pi x), exact at multiples of a quarter. Precondition: |x| < 1e9.
inline double cos_turns(double x) { return sin_turns(x + 0.25); }

}  // namespace boxwood
