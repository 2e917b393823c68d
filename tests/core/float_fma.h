// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

namespace boxwood {

/// a b + c rounded once, by integer arithmetic.
inline float float_fma_by_integers(float a, float b, float c) {
    __extension__ using Int128 = __int128;
    const double product = static_cast<double>(a) * b;
    if (!std::isfinite(product) || !std::isfinite(c) || product == 0 || c == 0)
        return static_cast<float>(product + c);
    int exponent, lower_exponent;
    const auto as_integer = [](double x, int& e) {
        const double mantissa = std::frexp(x, &e);
        e -= 53;
        return static_cast<std::int64_t>(std::ldexp(mantissa, 53));
    };
    std::int64_t upper = as_integer(product, exponent), lower = as_integer(c, lower_exponent);
    if (exponent < lower_exponent) {
        std::swap(upper, lower);
        std::swap(exponent, lower_exponent);
    }
    if (exponent - lower_exponent > 70) {  // too far below to count, but for its sign
        lower = lower < 0 ? -1 : 1;
        lower_exponent = exponent - 8;
    }
    const Int128 sum = (Int128{upper} * (Int128{1} << (exponent - lower_exponent))) + lower;
    Int128 size = sum < 0 ? -sum : sum;
    int shift = 0;
    for (; size >> 53 != 0; ++shift) size = size >> 1 | (size & 1);  // keeps whether bits were lost
    const double odd = std::ldexp(static_cast<double>(size), lower_exponent + shift);
    return static_cast<float>(sum < 0 ? -odd : odd);
}

/// std::fma, or its twin where the C library rounds that wrongly on floats, as musl does where it
/// can't set the rounding mode.
inline float float_fma(float a, float b, float c) {
#if defined(__wasm__)
    return float_fma_by_integers(a, b, c);
#else
    return std::fma(a, b, c);
#endif
}

}  // namespace boxwood
