// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/simd.h"
#include "boxwood/core/vectors.h"

namespace boxwood {

/// a b + c for numbers that were floats, so that the product is exact, rounded to odd in double:
/// where digits are lost, the last one kept is odd, so that rounding on to float sees on which side
/// of a tie the sum lies. It stands in for the fused multiply-add, where a machine has none.
/// Source: Boldo and Melquiond, "Emulation of a FMA and correctly rounded sums", IEEE Transactions
/// on Computers 57(4), 2008.
BOXWOOD_KERNEL Double2 fused_to_odd(Double2 a, Double2 b, Double2 c) {
    using Bits = decltype(a < b);
    const Double2 zero = {0, 0};
    const Double2 p = a * b, sum = p + c;
    const Double2 of_c = sum - p;
    const Double2 error = (p - (sum - of_c)) + (c - of_c);
    const Bits bits = reinterpret_cast<Bits>(sum);
    // Where the sum isn't exact and even: one step towards the error. An error that is no number
    // belongs to a sum that isn't finite, and leaves it as it is.
    const Bits more = zero < error;
    const Bits inexact = more | (error < zero);
    const Bits even = (bits & 1) - 1;
    const Bits shrinks = more ^ (zero < sum);
    return reinterpret_cast<Double2>(bits + ((shrinks | 1) & inexact & even));
}

}  // namespace boxwood
