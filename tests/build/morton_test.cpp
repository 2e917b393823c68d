// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/morton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boxwood/build/binned_sah.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "build/hard_boxes.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// The tree is valid, its leaves small enough, and no deeper than promised.
void expect_good_tree(const std::vector<Box3f>& boxes, const MortonOptions& options = {}) {
    const Tree tree = build_morton(boxes, options);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, options.largest_leaf);
    const double count = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
    EXPECT_LE(static_cast<double>(found.depth), 63 + std::ceil(std::log2(count)));
}

TEST(Morton, meshes_of_every_family_make_a_good_tree) {
    for (const std::uint32_t largest_leaf : {1, 2, 4, 16}) {
        SCOPED_TRACE(largest_leaf);
        for (const MeshFamily& family : mesh_families()) {
            SCOPED_TRACE(family.name);
            for (const bool full_leaves : {false, true})
                expect_good_tree(triangle_boxes(family.make()),
                                 {.largest_leaf = largest_leaf, .full_leaves = full_leaves});
        }
    }
}

TEST(Morton, hard_boxes_make_a_good_tree) {
    for (const auto& [name, boxes] : hard_boxes()) {
        SCOPED_TRACE(name);
        for (const std::uint32_t largest_leaf : {1, 16})
            for (const bool full_leaves : {false, true})
                expect_good_tree(boxes, {.largest_leaf = largest_leaf, .full_leaves = full_leaves});
    }
}

TEST(Morton, leaves_larger_than_a_task_will_do) {
    expect_good_tree(random_boxes(10'000, 1), {.largest_leaf = 5000});
    expect_good_tree(random_boxes(10'000, 1), {.largest_leaf = 1'000'000});
}

TEST(Morton, cells_of_few_leaves_leave_all_full_but_one) {
    for (std::size_t count = 17; count <= 48; ++count) {
        const TreeStatistics found = statistics(
            build_morton(random_boxes(count, 1), {.largest_leaf = 16, .full_leaves = true}));
        EXPECT_EQ(found.leaves, (count + 15) / 16) << count;
    }
    const std::vector<Box3f> boxes = triangle_boxes(generate_gyroid(20'000));
    const auto leaves = [&](bool full_leaves) {
        const Tree tree = build_morton(boxes, {.largest_leaf = 16, .full_leaves = full_leaves});
        return static_cast<double>(statistics(tree).leaves);
    };
    EXPECT_LT(leaves(true), 0.85 * leaves(false));
}

TEST(Morton, memory_to_sort_in_changes_nothing) {
    const std::vector<Box3f> boxes = random_boxes(10'000, 1);
    const Tree expected = build_morton(boxes);
    const Arena memory(16 * boxes.size() + 1);
    const auto is_written = [&] {
        return std::any_of(memory.bytes().begin(), memory.bytes().end(),
                           [](std::byte b) { return b != std::byte{0}; });
    };
    std::fill(memory.bytes().begin(), memory.bytes().end(), std::byte{0});
    // Too little, and in the wrong place.
    for (const auto scratch : {memory.bytes().first(16 * boxes.size() - 1),
                               memory.bytes().subspan(1, 16 * boxes.size())}) {
        EXPECT_TRUE(are_identical(build_morton(boxes, {.scratch = scratch}), expected));
        EXPECT_FALSE(is_written());
    }
    const auto enough = memory.bytes().first(16 * boxes.size());
    EXPECT_TRUE(are_identical(build_morton(boxes, {.scratch = enough}), expected));
    EXPECT_TRUE(is_written());
}

TEST(Morton, leaves_of_nothing_are_refused) {
    EXPECT_THROW(build_morton({}, {.largest_leaf = 0}), InvalidInput);
}

TEST(Morton, splits_halve_the_cube_along_x_then_y_then_z) {
    std::vector<Box3f> boxes;
    for (int i = 0; i < 8; ++i) {
        const Vec3f corner(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                           static_cast<float>(i >> 2));
        boxes.push_back({corner, corner});
    }
    const Tree tree = build_morton(boxes, {.largest_leaf = 1});
    EXPECT_EQ(tree.order, (std::vector<std::uint32_t>{0, 4, 2, 6, 1, 5, 3, 7}));
    EXPECT_EQ(statistics(tree).depth, 3u);
    EXPECT_EQ(tree.nodes[tree.root().left()].box, (Box3f{Vec3f(0, 0, 0), Vec3f(0, 1, 1)}));
}

TEST(Morton, equal_centroids_are_halved) {
    const std::vector<Box3f> copies(1000, {Vec3f::Zero(), Vec3f::Ones()});
    EXPECT_EQ(statistics(build_morton(copies, {.largest_leaf = 1})).depth, 10u);
}

TEST(Morton, one_far_away_spoils_nothing) {
    std::vector<Box3f> boxes = triangle_boxes(generate_gyroid(3000));
    const auto cost_of_most = [&] {
        // Of all nodes but the root, whose box the one far away makes huge.
        const Tree tree = build_morton(boxes);
        double cost = 0;
        for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
            const Node& node = tree.nodes[i];
            const bool is_large = node.box.extent().maxCoeff() > 1e6f;
            if (!is_large) cost += node.box.surface_area() * std::max(node.count, 1u);
        }
        return cost;
    };
    const double alone = cost_of_most();
    const Vec3f far = Vec3f::Constant(1e9f);
    boxes.push_back({far, far});
    const double with_one_far_away = cost_of_most();
    EXPECT_LT(with_one_far_away, 1.2 * alone);
}

TEST(Morton, sah_cost_is_near_that_of_binned_sah) {
    for (const TriangleMesh& mesh : {generate_gyroid(5000), generate_terrain(5000)}) {
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        EXPECT_LT(statistics(build_morton(boxes)).sah_cost,
                  1.4 * statistics(build_binned_sah(boxes)).sah_cost);
    }
}

TEST(Morton, boxes_that_are_nan_keep_every_primitive) {
    Tree tree = build_morton(boxes_with_nan());
    std::sort(tree.order.begin(), tree.order.end());
    for (std::uint32_t i = 0; i < tree.order.size(); ++i) ASSERT_EQ(tree.order[i], i);
}

}  // namespace
}  // namespace boxwood
