// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/build.h"

#include <gtest/gtest.h>

#include "boxwood/build/binned_sah.h"
#include "boxwood/build/median.h"
#include "boxwood/build/morton.h"
#include "boxwood/build/ploc.h"
#include "boxwood/build/reinsertion.h"
#include "boxwood/build/spatial_split.h"
#include "boxwood/build/sweep_sah.h"
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
    EXPECT_TRUE(
        are_identical(build_tree(boxes, {.method = BuildMethod::morton}), build_morton(boxes)));
    EXPECT_TRUE(are_identical(build_tree(boxes, {.method = BuildMethod::ploc}), build_ploc(boxes)));
    EXPECT_TRUE(are_identical(build_tree(boxes, {.method = BuildMethod::sweep_sah}),
                              build_sweep_sah(boxes)));
    for (const auto& [name, cost] : merge_costs()) {
        const BuildOptions options = {.method = BuildMethod::agglomerative, .cost = cost};
        EXPECT_TRUE(
            are_identical(build_tree(boxes, options), build_agglomerative(boxes, {.cost = cost})))
            << name;
    }
}

TEST(Build, methods_that_see_triangles_reach_their_builders) {
    const TriangleMesh mesh = generate_soup(300);
    Tree tree = build_spatial_split(mesh);
    EXPECT_TRUE(are_identical(build_tree(mesh, {.method = BuildMethod::spatial_split}), tree));
    optimize_by_reinsertion(tree);
    EXPECT_TRUE(are_identical(build_tree(mesh, {.method = BuildMethod::reinsertion}), tree));
}

TEST(Build, boxes_are_never_split) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(300));
    Tree tree = build_binned_sah(boxes);
    EXPECT_TRUE(are_identical(build_tree(boxes, {.method = BuildMethod::spatial_split}), tree));
    optimize_by_reinsertion(tree);
    EXPECT_TRUE(are_identical(build_tree(boxes, {.method = BuildMethod::reinsertion}), tree));
}

TEST(Build, methods_and_costs_have_their_names) {
    std::vector<std::string_view> names;
    for (const auto& method : build_methods()) names.push_back(method.name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"median", "agglomerative", "binned_sah",
                                                    "block_sah", "morton", "ploc", "sweep_sah",
                                                    "spatial_split", "reinsertion"}));
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
