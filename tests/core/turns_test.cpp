// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/turns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxwood {
namespace {

TEST(Turns, agree_with_the_sine_and_cosine_of_the_c_library) {
    for (int i = -1000; i <= 1000; ++i) {
        const double x = i / 1009.0;  // few turns, as 2 pi x is rounded
        EXPECT_NEAR(sin_turns(x), std::sin(2 * std::acos(-1.0) * x), 2e-15) << x;
        EXPECT_NEAR(cos_turns(x), std::cos(2 * std::acos(-1.0) * x), 2e-15) << x;
    }
}

TEST(Turns, are_exact_at_quarters) {
    for (const double turns : {-3.0, 0.0, 1.0, 1000000.0}) {
        EXPECT_EQ(sin_turns(turns), 0);
        EXPECT_EQ(sin_turns(turns + 0.25), 1);
        EXPECT_EQ(sin_turns(turns + 0.5), 0);
        EXPECT_EQ(sin_turns(turns + 0.75), -1);
        EXPECT_EQ(cos_turns(turns), 1);
        EXPECT_EQ(cos_turns(turns + 0.25), 0);
        EXPECT_EQ(cos_turns(turns + 0.5), -1);
        EXPECT_EQ(cos_turns(turns + 0.75), 0);
    }
}

TEST(Turns, lie_on_the_unit_circle) {
    for (int i = 0; i < 10000; ++i) {
        const double s = sin_turns(i / 10007.0), c = cos_turns(i / 10007.0);
        EXPECT_NEAR(s * s + c * c, 1, 1e-15) << i;
        EXPECT_LE(std::abs(s), 1);
        EXPECT_LE(std::abs(c), 1);
    }
}

}  // namespace
}  // namespace boxwood
