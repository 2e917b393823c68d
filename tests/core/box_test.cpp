// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/box.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace boxwood {
namespace {

TEST(Box, without_corners_is_empty_and_extends_nothing) {
    const Box3d empty;
    EXPECT_TRUE(empty.is_empty());
    EXPECT_EQ(empty.surface_area(), 0);
    EXPECT_EQ(empty.volume(), 0);
    const Box3d unit = {Vec3d::Zero(), Vec3d::Ones()};
    EXPECT_EQ(merged(unit, empty), unit);
    EXPECT_EQ(merged(empty, unit), unit);
    EXPECT_EQ(merged(empty, empty), empty);
    EXPECT_TRUE(unit.contains(empty));
    EXPECT_TRUE(empty.contains(empty));
    EXPECT_FALSE(empty.contains(unit));
}

TEST(Box, is_empty_when_one_coordinate_is_or_is_nan) {
    Box3d box = {Vec3d(0, 2, 0), Vec3d(1, 1, 1)};
    EXPECT_TRUE(box.is_empty());
    box.lo.y() = std::nan("");
    EXPECT_TRUE(box.is_empty());
    box.lo.y() = 1;  // flat, which is not empty
    EXPECT_FALSE(box.is_empty());
}

TEST(Box, extends_to_the_smallest_around_points) {
    Box3d box;
    box.extend(Vec3d(1, -2, 3)).extend(Vec3d(-1, 5, 3));
    EXPECT_EQ(box, (Box3d{Vec3d(-1, -2, 3), Vec3d(1, 5, 3)}));
    EXPECT_EQ(box.centroid(), Vec3d(0, 1.5, 3));
    EXPECT_EQ(box.extent(), Vec3d(2, 7, 0));
    EXPECT_EQ(box.longest_axis(), 1);
    EXPECT_EQ(box.surface_area(), 28);
    EXPECT_EQ(box.volume(), 0);
}

TEST(Box, longest_axis_is_the_first_on_a_tie) {
    EXPECT_EQ((Box3d{Vec3d::Zero(), Vec3d(1, 1, 1)}.longest_axis()), 0);
    EXPECT_EQ((Box3d{Vec3d::Zero(), Vec3d(1, 2, 2)}.longest_axis()), 1);
}

TEST(Box, contains_what_touches_its_faces_from_inside) {
    const Box3d unit = {Vec3d::Zero(), Vec3d::Ones()};
    EXPECT_TRUE(unit.contains(unit));
    EXPECT_TRUE(unit.contains({Vec3d(0, 0.2, 1), Vec3d(1, 0.4, 1)}));
    EXPECT_FALSE(unit.contains({Vec3d(0, 0, 0), Vec3d(1, 1, 1.0000001)}));
    EXPECT_FALSE(unit.contains({Vec3d(-1, 0, 0), Vec3d(1, 1, 1)}));
}

TEST(Box, area_volume_and_centroid_of_the_largest_box_are_finite) {
    const Box3f all = {Vec3f::Constant(-FLT_MAX), Vec3f::Constant(FLT_MAX)};
    EXPECT_NEAR(all.surface_area() / (24.0 * FLT_MAX * FLT_MAX), 1, 1e-12);
    EXPECT_NEAR(all.volume() / (8.0 * FLT_MAX * FLT_MAX * FLT_MAX), 1, 1e-12);
    EXPECT_EQ(all.centroid(), Vec3f::Zero());
}

}  // namespace
}  // namespace boxwood
