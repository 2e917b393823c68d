// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/ploc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boxwood/build/agglomerative.h"
#include "boxwood/build/binned_sah.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "build/hard_boxes.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// The tree is valid, its leaves small enough, and no deeper than promised.
void expect_good_tree(const std::vector<Box3f>& boxes, const PlocOptions& options = {}) {
    const Tree tree = build_ploc(boxes, options);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, options.largest_leaf);
    const double count = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
    EXPECT_LE(static_cast<double>(found.depth), 64 + std::ceil(5.2 * std::log2(count)));
}

TEST(Ploc, meshes_of_every_family_make_a_good_tree) {
    for (const std::uint32_t largest_leaf : {1, 4, 16}) {
        SCOPED_TRACE(largest_leaf);
        for (const MeshFamily& family : mesh_families()) {
            SCOPED_TRACE(family.name);
            expect_good_tree(triangle_boxes(family.make()), {.largest_leaf = largest_leaf});
        }
    }
}

TEST(Ploc, hard_boxes_make_a_good_tree) {
    for (const auto& [name, boxes] : hard_boxes()) {
        SCOPED_TRACE(name);
        for (const int radius : {1, 8, 32}) expect_good_tree(boxes, {.radius = radius});
        expect_good_tree(boxes, {.largest_leaf = 1});
    }
}

TEST(Ploc, any_radius_will_do) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_torus_knot(6000));
    for (int radius = 1; radius <= 32; ++radius) {
        SCOPED_TRACE(radius);
        expect_good_tree(boxes, {.radius = radius});
    }
}

TEST(Ploc, options_out_of_range_are_refused) {
    for (const int radius : {-1, 0, 33})
        EXPECT_THROW(build_ploc({}, {.radius = radius}), InvalidInput) << radius;
    EXPECT_THROW(build_ploc({}, {.largest_leaf = 0}), InvalidInput);
}

/// With each other in sight, nodes that are each other's best merge sooner or later either way.
TEST(Ploc, within_the_radius_it_merges_what_agglomerative_does) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const std::vector<Box3f> boxes = random_boxes(2 + seed % 30, 1, seed);
        const Tree ploc = build_ploc(boxes, {.radius = 32, .largest_leaf = 1});
        const Tree slow = build_agglomerative(boxes);
        const auto inner_boxes = [](const Tree& tree) {
            std::vector<double> areas;
            for (const Node& node : tree.nodes) areas.push_back(node.box.surface_area());
            std::sort(areas.begin(), areas.end());
            return areas;
        };
        EXPECT_EQ(inner_boxes(ploc), inner_boxes(slow)) << "seed " << seed;
    }
}

TEST(Ploc, equal_boxes_are_paired_off_in_each_round) {
    for (const std::size_t count : {10, 1024, 10'000}) {
        const std::vector<Box3f> copies(count, {Vec3f::Zero(), Vec3f::Ones()});
        EXPECT_EQ(static_cast<double>(statistics(build_ploc(copies, {.largest_leaf = 1})).depth),
                  std::ceil(std::log2(count)));
    }
}

/// Two sets of equal boxes that alternate along the curve: partners are two places apart.
TEST(Ploc, alternating_boxes_make_no_chain) {
    std::vector<Box3f> boxes;
    for (int i = 0; i < 4096; ++i) {
        const float size = i % 2 ? 1 : 100;
        boxes.push_back({Vec3f::Constant(-size), Vec3f::Constant(size)});
    }
    for (const int radius : {2, 3, 8})
        EXPECT_LE(statistics(build_ploc(boxes, {.radius = radius})).depth, 30u) << radius;
}

TEST(Ploc, costs_decide_between_leaves_and_merges) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(1000));
    const auto leaves = [&](double node_cost) {
        return statistics(build_ploc(boxes, {.largest_leaf = 8, .node_cost = node_cost})).leaves;
    };
    EXPECT_LT(leaves(100), leaves(0.01));
    EXPECT_EQ(leaves(0), boxes.size());
}

TEST(Ploc, sah_cost_is_near_that_of_binned_sah) {
    for (const TriangleMesh& mesh :
         {generate_gyroid(5000), generate_terrain(5000), generate_soup(5000)}) {
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        EXPECT_LT(statistics(build_ploc(boxes)).sah_cost,
                  1.15 * statistics(build_binned_sah(boxes)).sah_cost);
    }
}

TEST(Ploc, boxes_that_are_nan_keep_every_primitive) {
    Tree tree = build_ploc(boxes_with_nan());
    std::sort(tree.order.begin(), tree.order.end());
    for (std::uint32_t i = 0; i < tree.order.size(); ++i) ASSERT_EQ(tree.order[i], i);
}

}  // namespace
}  // namespace boxwood
