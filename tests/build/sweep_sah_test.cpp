// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/sweep_sah.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
void expect_good_tree(const std::vector<Box3f>& boxes, const SweepSahOptions& options = {}) {
    const Tree tree = build_sweep_sah(boxes, options);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, options.largest_leaf);
    const double count = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
    EXPECT_LE(static_cast<double>(found.depth), 40 + std::ceil(std::log2(count)));
}

TEST(SweepSah, meshes_of_every_family_make_a_good_tree) {
    for (const std::uint32_t largest_leaf : {1, 2, 4, 16}) {
        SCOPED_TRACE(largest_leaf);
        for (const MeshFamily& family : mesh_families()) {
            SCOPED_TRACE(family.name);
            expect_good_tree(triangle_boxes(family.make()), {.largest_leaf = largest_leaf});
        }
    }
}

TEST(SweepSah, hard_boxes_make_a_good_tree) {
    for (const auto& [name, boxes] : hard_boxes()) {
        SCOPED_TRACE(name);
        expect_good_tree(boxes, {.largest_leaf = 1});
        expect_good_tree(boxes, {.largest_leaf = 16, .leaf_block = 8});
    }
}

TEST(SweepSah, options_out_of_range_are_refused) {
    EXPECT_THROW(build_sweep_sah({}, {.largest_leaf = 0}), InvalidInput);
    EXPECT_THROW(build_sweep_sah({}, {.leaf_block = 0}), InvalidInput);
}

/// The oracle: all splits along all axes, each side's box from scratch.
double cheapest_split(const std::vector<Box3f>& boxes) {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Box3f> sorted = boxes;
        std::sort(sorted.begin(), sorted.end(), [axis](const Box3f& a, const Box3f& b) {
            return a.centroid()[axis] < b.centroid()[axis];
        });
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            Box3f left, right;
            for (std::size_t k = 0; k < i; ++k) left.extend(sorted[k]);
            for (std::size_t k = i; k < sorted.size(); ++k) right.extend(sorted[k]);
            least =
                std::min(least, left.surface_area() * static_cast<double>(i) +
                                    right.surface_area() * static_cast<double>(boxes.size() - i));
        }
    }
    return least;
}

std::vector<Box3f> boxes_below(const Tree& tree, const Node& node,
                               const std::vector<Box3f>& boxes) {
    std::vector<Box3f> result;
    if (node.is_leaf()) {
        for (const std::uint32_t primitive : tree.primitives(node))
            result.push_back(boxes[primitive]);
        return result;
    }
    for (const std::uint32_t child : {node.left(), node.right()}) {
        const std::vector<Box3f> part = boxes_below(tree, tree.nodes[child], boxes);
        result.insert(result.end(), part.begin(), part.end());
    }
    return result;
}

TEST(SweepSah, every_split_is_the_cheapest) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const std::vector<Box3f> boxes = random_boxes(60, 1, seed);
        const Tree tree = build_sweep_sah(boxes, {.largest_leaf = 1});
        for (const Node& node : tree.nodes) {
            if (node.is_leaf()) continue;
            double cost = 0;
            for (const std::uint32_t child : {node.left(), node.right()}) {
                const std::vector<Box3f> part = boxes_below(tree, tree.nodes[child], boxes);
                cost += tree.nodes[child].box.surface_area() * static_cast<double>(part.size());
            }
            const double least = cheapest_split(boxes_below(tree, node, boxes));
            EXPECT_NEAR(cost, least, 1e-5 * least) << "seed " << seed;
        }
    }
}

TEST(SweepSah, sah_cost_is_below_that_of_binned_sah) {
    for (const TriangleMesh& mesh :
         {generate_gyroid(5000), generate_terrain(5000), generate_soup(5000)}) {
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        EXPECT_LT(statistics(build_sweep_sah(boxes)).sah_cost,
                  statistics(build_binned_sah(boxes)).sah_cost);
    }
}

TEST(SweepSah, equal_boxes_are_halved) {
    const std::vector<Box3f> copies(1000, {Vec3f::Zero(), Vec3f(1, 2, 3)});
    EXPECT_EQ(statistics(build_sweep_sah(copies, {.largest_leaf = 1})).depth, 10u);
}

TEST(SweepSah, leaves_fill_their_blocks) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(4000));
    const auto mean_leaf = [&](std::uint32_t block) {
        const SweepSahOptions options = {.largest_leaf = 8, .leaf_block = block};
        return 4000.0 / static_cast<double>(statistics(build_sweep_sah(boxes, options)).leaves);
    };
    EXPECT_GT(mean_leaf(8), 1.5 * mean_leaf(1));
    EXPECT_GT(mean_leaf(8), 5);
}

TEST(SweepSah, boxes_that_are_nan_keep_every_primitive) {
    Tree tree = build_sweep_sah(boxes_with_nan());
    std::sort(tree.order.begin(), tree.order.end());
    for (std::uint32_t i = 0; i < tree.order.size(); ++i) ASSERT_EQ(tree.order[i], i);
}

}  // namespace
}  // namespace boxwood
