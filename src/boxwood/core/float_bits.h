// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

namespace boxwood {

/// What a float looks like in memory. Of positive ones, the larger has the larger bits.
inline std::uint32_t bits_of(float x) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

/// The float that looks like this.
inline float float_of(std::uint32_t bits) {
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

/// The e of 2^e <= |x| < 2^(e+1). Precondition: x is neither zero nor subnormal, and finite.
inline int exponent_of(double x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return static_cast<int>(bits >> 52 & 0x7ff) - 1023;
}

/// 2^e. Precondition: -1022 <= e <= 1023.
inline double power_of_two(int e) {
    const std::uint64_t bits = static_cast<std::uint64_t>(e + 1023) << 52;
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

}  // namespace boxwood
