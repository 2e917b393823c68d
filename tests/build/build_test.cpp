// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/build.h"

#include <gtest/gtest.h>

#include "boxwood/build/binned_sah.h"
#include "boxwood/build/median.h"
#include "boxwood/mesh/generate.h"
#include "laws/hits.h"

namespace boxwood {
namespace {

TEST(Build, default_is_binned_sah) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(300));
    EXPECT_TRUE(are_identical(build_tree(boxes), build_binned_sah(boxes)));
}

TEST(Build, methods_and_costs_reach_their_builders) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(300));
    EXPECT_TRUE(
        are_identical(build_tree(boxes, {.method = BuildMethod::median}), build_median(boxes)));
    for (const auto& [name, cost] : merge_costs()) {
        const BuildOptions options = {.method = BuildMethod::agglomerative, .cost = cost};
        EXPECT_TRUE(
            are_identical(build_tree(boxes, options), build_agglomerative(boxes, {.cost = cost})))
            << name;
    }
}

TEST(Build, methods_and_costs_have_the_names_of_the_assignment) {
    ASSERT_EQ(build_methods().size(), 3u);
    EXPECT_EQ(build_methods()[0].name, "median");
    EXPECT_EQ(build_methods()[1].name, "agglomerative");
    EXPECT_EQ(build_methods()[2].name, "binned_sah");
    ASSERT_EQ(merge_costs().size(), 3u);
    EXPECT_EQ(merge_costs()[0].name, "centroid_distance");
    EXPECT_EQ(merge_costs()[1].name, "volume_increase");
    EXPECT_EQ(merge_costs()[2].name, "surface_area");
}

TEST(Build, warns_before_agglomerating_more_than_200000_triangles) {
    const BuildOptions agglomerative = {.method = BuildMethod::agglomerative};
    EXPECT_FALSE(warning_before_build(200'000, agglomerative));
    const auto warning = warning_before_build(1'000'000, agglomerative);
    ASSERT_TRUE(warning);
    EXPECT_NE(warning->find("1000000 triangles"), std::string::npos) << *warning;
    EXPECT_TRUE(warning_before_build(200'001, agglomerative));
    EXPECT_FALSE(warning_before_build(10'000'000, {.method = BuildMethod::binned_sah}));
    EXPECT_FALSE(warning_before_build(10'000'000, {.method = BuildMethod::median}));
}

}  // namespace
}  // namespace boxwood
