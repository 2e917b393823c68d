// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/placement.h"

#include <gtest/gtest.h>

#include "boxwood/core/error.h"
#include "laws/random.h"

namespace boxwood {
namespace {

Eigen::Affine3d random_map(Random& random) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.translate(random.point(-100, 100)).rotate(Eigen::AngleAxisd(3, random.direction()));
    return map.scale(random.point(0.001, 1)).rotate(Eigen::AngleAxisd(2, random.direction()));
}

TEST(Placement, nothing_moves_by_default) {
    const Placement placement;
    EXPECT_TRUE(placement.is_identity());
    EXPECT_EQ(placement.to_world({1, 2, 3}), Vec3d(1, 2, 3));
    EXPECT_EQ(placement.to_local({1, 2, 3}), Vec3d(1, 2, 3));
    EXPECT_TRUE(Placement(Eigen::Affine3d::Identity()).is_identity());
}

/// In long double, there and back.
TEST(Placement, places_are_no_farther_off_than_it_says) {
    using Vec3 = Eigen::Matrix<long double, 3, 1>;
    using Mat3 = Eigen::Matrix<long double, 3, 3>;
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Affine3d map = random_map(random);
        const Placement placement(map);
        const Mat3 inverse = map.linear().cast<long double>().inverse();
        const Vec3 offset = map.translation().cast<long double>();
        for (int k = 0; k < 20; ++k) {
            const Vec3d world = random.point(-1000, 1000), local = random.point(-1, 1);
            const double room = placement.rounding(world, 1);
            const Vec3 exact = inverse * (world.cast<long double>() - offset);
            EXPECT_LE((exact - placement.to_local(world).cast<long double>()).norm(), room);
            // What a vertex is that is rounded in the world.
            const Vec3 back = inverse * (placement.to_world(local).cast<long double>() - offset);
            EXPECT_LE((back - local.cast<long double>()).norm(), room);
        }
    }
}

TEST(Placement, knows_what_the_map_does_to_lengths_and_angles) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.rotate(Eigen::AngleAxisd(1, Vec3d(1, 2, 3).normalized())).scale(5);
    EXPECT_TRUE(Placement(map).keeps_angles());
    EXPECT_FALSE(Placement(map).is_mirrored());
    EXPECT_GE(Placement(map).most_growth(), 5);
    EXPECT_GE(Placement(map).most_shrinking(), 0.2);
    map.scale(Vec3d(1, 1, -1));
    EXPECT_TRUE(Placement(map).keeps_angles());
    EXPECT_TRUE(Placement(map).is_mirrored());
    map.scale(Vec3d(1, 1.001, 1));
    EXPECT_FALSE(Placement(map).keeps_angles());
}

TEST(Placement, maps_without_an_inverse_are_refused) {
    for (const double thin : {0.0, 1e-13, 1e-300}) {
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.rotate(Eigen::AngleAxisd(1, Vec3d(1, 2, 3).normalized())).scale(Vec3d(1, 1, thin));
        EXPECT_THROW(Placement{map}, InvalidInput) << thin;
    }
    Eigen::Affine3d small = Eigen::Affine3d::Identity();
    small.scale(1e-80);
    EXPECT_NO_THROW(Placement{small});
    Eigen::Affine3d smaller = small;
    smaller.scale(1e-80);
    EXPECT_THROW(Placement{smaller}, InvalidInput);
    small.scale(0);
    EXPECT_THROW(Placement{small}, InvalidInput);
}

}  // namespace
}  // namespace boxwood
