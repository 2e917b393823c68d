// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/round_outward.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

#include "laws/random.h"

namespace boxwood {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(RoundedOutward, is_the_smallest_float_box_around) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const double scale = std::pow(10, random.number(-44, 38));
        Box3d box;
        box.extend(scale * random.point(-1, 1)).extend(scale * random.point(-1, 1));
        const Box3f rounded = rounded_outward(box);
        for (int k = 0; k < 3; ++k) {
            ASSERT_LE(rounded.lo[k], box.lo[k]) << i;
            ASSERT_GE(rounded.hi[k], box.hi[k]) << i;
            ASSERT_GT(std::nextafter(rounded.lo[k], kInfinity), box.lo[k]) << i;
            ASSERT_LT(std::nextafter(rounded.hi[k], -kInfinity), box.hi[k]) << i;
        }
    }
}

TEST(RoundedOutward, keeps_what_is_a_float) {
    const Box3d box = {Vec3d(-0.5, 0, -FLT_MAX), Vec3d(0.25, 0, FLT_MAX)};
    EXPECT_EQ(rounded_outward(box), (Box3f{Vec3f(-0.5f, 0, -FLT_MAX), Vec3f(0.25f, 0, FLT_MAX)}));
}

TEST(RoundedOutward, is_empty_beyond_the_range_of_float) {
    const Box3d good = {Vec3d::Zero(), Vec3d::Ones()};
    const double beyond = std::nextafter(double{FLT_MAX}, HUGE_VAL);
    for (const double bad : {beyond, 1e39, 1e300, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        for (int k = 0; k < 3; ++k) {
            Box3d box = good;
            box.hi[k] = bad;
            EXPECT_EQ(rounded_outward(box), Box3f{}) << bad;
            box = good;
            box.lo[k] = -bad;
            EXPECT_EQ(rounded_outward(box), Box3f{}) << bad;
        }
    }
    EXPECT_TRUE(rounded_outward(Box3d{}).is_empty());
}

TEST(RoundedOutward, numbers_too_small_for_float_stay_inside) {
    const Box3d box = {Vec3d::Constant(-1e-300), Vec3d::Constant(1e-300)};
    const Box3f rounded = rounded_outward(box);
    EXPECT_LT(rounded.lo.x(), 0);
    EXPECT_GT(rounded.hi.x(), 0);
    EXPECT_LT(rounded.hi.x(), 1e-44);
}

}  // namespace
}  // namespace boxwood
