// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/block_sah.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/wide_tree.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

Box3f point_box(double x, double y, double z) {
    const Vec3f p = Vec3d(x, y, z).cast<float>();
    return {p, p};
}

/// The tree is valid, its leaves small enough, and no deeper than promised.
void expect_good_tree(const std::vector<Box3f>& boxes, const BlockSahOptions& options = {}) {
    const Tree tree = build_block_sah(boxes, options);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, options.block);
    EXPECT_LE(
        static_cast<double>(found.depth),
        40 + std::ceil(std::log2(static_cast<double>(std::max<std::size_t>(boxes.size(), 1)))));
}

TEST(BlockSah, leaves_are_no_larger_than_asked) {
    for (const std::uint32_t block : {1, 2, 3, 4, 8, 16, 256}) {
        SCOPED_TRACE(block);
        for (const MeshFamily& family : mesh_families()) {
            SCOPED_TRACE(family.name);
            expect_good_tree(triangle_boxes(family.make()), {.block = block});
        }
    }
}

TEST(BlockSah, mesh_and_its_boxes_give_the_same_tree) {
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        EXPECT_TRUE(are_identical(build_block_sah(mesh), build_block_sah(triangle_boxes(mesh))))
            << family.name;
    }
}

TEST(BlockSah, cuts_by_cost_end_at_the_depth_asked_for) {
    for (const MeshFamily& family : mesh_families()) {
        const std::vector<Box3f> boxes = triangle_boxes(family.make());
        for (const int deepest : {-1, 0, 3}) {
            const Tree tree = build_block_sah(boxes, {.block = 1, .deepest_sah_split = deepest});
            ASSERT_EQ(find_fault(tree, boxes), std::nullopt) << family.name;
            const double count = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
            // The hidden ones are a level of their own.
            EXPECT_LE(static_cast<double>(statistics(tree).depth),
                      std::max(deepest, 1) + std::ceil(std::log2(count)))
                << family.name;
        }
    }
}

TEST(BlockSah, options_out_of_range_are_refused) {
    const std::vector<Box3f> boxes(3, {Vec3f::Zero(), Vec3f::Ones()});
    EXPECT_THROW(build_block_sah(boxes, {.block = 0}), InvalidInput);
    EXPECT_THROW(build_block_sah(boxes, {.block = 257}), InvalidInput);
    EXPECT_THROW(build_block_sah(boxes, {.deepest_sah_split = 41}), InvalidInput);
    EXPECT_THROW(build_block_sah(TriangleMesh{}, {.block = 0}), InvalidInput);
}

TEST(BlockSah, wide_trees_cost_little_more_than_over_binned_sah) {
    for (const char* name : {"icosphere", "soup", "torus_knot", "terrain", "gyroid"}) {
        const TriangleMesh mesh = generate(name, 20'000);
        for (const auto& [set_name, set] : instruction_sets()) {
            if (!is_supported(set)) continue;
            const auto block = static_cast<std::uint32_t>(lanes(set));
            const WideTree fast(mesh, build_block_sah(mesh, {.block = block}), {set});
            const WideTree textbook(mesh, build_tree(mesh), {set});
            EXPECT_LE(fast.cost(), 1.06 * textbook.cost()) << name << " " << set_name;
        }
    }
}

TEST(BlockSah, depth_is_bounded_on_places_that_double) {
    std::vector<Box3f> boxes;
    boxes.reserve(3500);
    for (int i = 0; i < 3000; ++i) boxes.push_back(point_box(std::ldexp(1, i % 250 - 125), 0, 0));
    for (int i = 0; i < 250; ++i) {
        boxes.push_back(point_box(0, std::ldexp(1, -i / 2), 0));
        boxes.push_back({Vec3f::Zero(), Vec3f::Constant(std::ldexp(1.0f, i / 2 - 60))});
    }
    for (const std::uint32_t block : {1, 4}) expect_good_tree(boxes, {.block = block});
}

TEST(BlockSah, any_extent_of_float_will_do) {
    for (const double scale : {1e-45, 1e-40, 1e-37, 1e-30, 1e-20, 1e20, 1e30, 1e37, 3e38}) {
        SCOPED_TRACE(scale);
        Random random(1);
        std::vector<Box3f> boxes(500);
        for (Box3f& box : boxes) {
            box.extend((scale * random.point(-1, 1)).cast<float>());
            box.extend((scale * random.point(-1, 1)).cast<float>());
        }
        expect_good_tree(boxes);
        // Tiny ones among them, where one scale must serve both.
        for (std::size_t i = 0; i < boxes.size(); i += 2) boxes[i] = point_box(1e-45 * i, 0, 1e-44);
        expect_good_tree(boxes);
        // Flat along one axis, and all of it a line.
        for (Box3f& box : boxes) box.lo.x() = box.hi.x() = 1;
        expect_good_tree(boxes);
        for (Box3f& box : boxes) box.lo.z() = box.hi.z() = kLargest;
        expect_good_tree(boxes);
    }
}

TEST(BlockSah, extreme_empty_and_infinite_boxes_make_a_valid_tree) {
    const Vec3f largest = Vec3f::Constant(kLargest);
    const Vec3f infinite = Vec3f::Constant(std::numeric_limits<float>::infinity());
    std::vector<Box3f> boxes;
    for (int i = 0; i < 40; ++i) {
        boxes.push_back({-largest, largest});
        boxes.push_back({largest, largest});
        boxes.push_back({-largest, -largest});
        boxes.push_back({});
        boxes.push_back(point_box(i, i, i));
        boxes.push_back({-infinite, infinite});
    }
    expect_good_tree(boxes);
    expect_good_tree(std::vector<Box3f>(100));
    expect_good_tree(std::vector<Box3f>(100, {-largest, largest}));
    expect_good_tree({{-largest, -largest}, {largest, largest}});
    expect_good_tree({});
    expect_good_tree({Box3f{}});
}

/// Not made by triangle_boxes(), but by a caller of build_tree(boxes).
TEST(BlockSah, boxes_that_are_nan_keep_every_primitive) {
    std::vector<Box3f> boxes = triangle_boxes(generate_soup(200));
    const Vec3f nan = Vec3f::Constant(std::nanf(""));
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = {nan, nan};
    std::vector<std::uint32_t> order = build_block_sah(boxes).order;
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(order[i], i);
}

/// Many pieces and tasks, hidden boxes in some pieces only.
TEST(BlockSah, large_inputs_give_the_same_valid_tree_for_any_number_of_threads) {
    constexpr std::size_t kBoxes = kIsSanitized ? 60'000 : 200'000;
    const std::vector<Box3f> usual = triangle_boxes(generate_soup(kBoxes));
    std::vector<Box3f> with_hidden = usual;
    for (std::size_t i = kBoxes / 10; i < kBoxes / 4 * 3; i += 1 + i % 7) with_hidden[i] = {};
    std::vector<Box3f> equal(kBoxes / 2 * 3, usual[0]);
    std::vector<Box3f> spanned = usual;
    spanned[0] = {Vec3f::Constant(-1e30f), Vec3f::Constant(1e30f)};
    for (const auto& boxes : {usual, with_hidden, equal, spanned, std::vector<Box3f>(kBoxes / 2)}) {
        expect_good_tree(boxes);
        std::vector<Tree> trees;
        for (const std::size_t threads : {1, 2, 5}) {
            const ThreadLimit limit(threads);
            trees.push_back(build_block_sah(boxes));
        }
        EXPECT_TRUE(are_identical(trees[0], trees[1]));
        EXPECT_TRUE(are_identical(trees[0], trees[2]));
    }
}

}  // namespace
}  // namespace boxwood
