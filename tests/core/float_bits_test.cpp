// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/float_bits.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace boxwood {
namespace {

TEST(FloatBits, exponents_are_those_of_the_standard_library) {
    for (int e = -1022; e <= 1023; ++e) {
        EXPECT_EQ(power_of_two(e), std::ldexp(1.0, e));
        for (const double x : {1.0, 1.5, std::nextafter(2.0, 0.0)}) {
            EXPECT_EQ(exponent_of(std::ldexp(x, e)), std::ilogb(std::ldexp(x, e)));
            EXPECT_EQ(exponent_of(-std::ldexp(x, e)), e);
        }
    }
    EXPECT_EQ(exponent_of(DBL_MAX), 1023);
    EXPECT_EQ(exponent_of(DBL_MIN), -1022);
}

}  // namespace
}  // namespace boxwood
