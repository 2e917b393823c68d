// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/binned_sah.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/build/build.h"
#include "boxwood/core/error.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
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
void expect_good_tree(const std::vector<Box3f>& boxes, const BinnedSahOptions& options = {}) {
    const Tree tree = build_binned_sah(boxes, options);
    ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, options.largest_leaf);
    EXPECT_LE(
        static_cast<double>(found.depth),
        40 + std::ceil(std::log2(static_cast<double>(std::max<std::size_t>(boxes.size(), 1)))));
}

TEST(BinnedSah, leaves_are_no_larger_than_asked) {
    for (const std::uint32_t largest_leaf : {1, 2, 4, 16}) {
        SCOPED_TRACE(largest_leaf);
        for (const MeshFamily& family : mesh_families()) {
            SCOPED_TRACE(family.name);
            expect_good_tree(triangle_boxes(family.make()), {.largest_leaf = largest_leaf});
        }
    }
}

TEST(BinnedSah, any_number_of_bins_will_do) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_torus_knot(1000));
    for (int bins = 2; bins <= 32; ++bins) {
        SCOPED_TRACE(bins);
        expect_good_tree(boxes, {.bins = bins});
    }
}

TEST(BinnedSah, options_out_of_range_are_refused) {
    const std::vector<Box3f> boxes(3, {Vec3f::Zero(), Vec3f::Ones()});
    for (const int bins : {-1, 0, 1, 33})
        EXPECT_THROW(build_binned_sah(boxes, {.bins = bins}), InvalidInput) << bins;
    EXPECT_THROW(build_binned_sah(boxes, {.largest_leaf = 0}), InvalidInput);
    EXPECT_THROW(build_binned_sah({}, {.bins = 1}), InvalidInput);
}

TEST(BinnedSah, sah_cost_is_below_that_of_median) {
    const std::vector<std::pair<std::string, TriangleMesh>> meshes = {
        {"icosphere", generate_icosphere(5000)},   {"soup", generate_soup(5000)},
        {"torus_knot", generate_torus_knot(5000)}, {"terrain", generate_terrain(5000)},
        {"gyroid", generate_gyroid(5000)},
    };
    for (const auto& [name, mesh] : meshes) {
        const double binned = statistics(build_tree(mesh)).sah_cost;
        const double median =
            statistics(build_tree(mesh, {.method = BuildMethod::median})).sah_cost;
        EXPECT_LE(binned, median) << name;
    }
}

TEST(BinnedSah, two_clusters_are_split_between_them) {
    std::vector<Box3f> boxes;
    for (int i = 0; i < 10; ++i) boxes.push_back(point_box(0.01 * i, 0, 0));
    boxes.push_back(point_box(100, 0, 0));
    boxes.push_back(point_box(100, 1, 0));
    for (Box3f& box : boxes) box.hi += Vec3f::Constant(0.01f);
    const Tree tree = build_binned_sah(boxes);
    EXPECT_LT(tree.nodes[tree.root().left()].box.hi.x(), 1);
    EXPECT_EQ(tree.nodes[tree.root().right()].box.lo.x(), 100);
}

TEST(BinnedSah, costs_decide_between_leaves_and_splits) {
    const std::vector<Box3f> boxes = triangle_boxes(generate_soup(1000));
    const auto leaves = [&](double node_cost) {
        const BinnedSahOptions options = {.largest_leaf = 8, .node_cost = node_cost};
        return statistics(build_binned_sah(boxes, options)).leaves;
    };
    EXPECT_LT(leaves(100), leaves(0.01));
    EXPECT_EQ(leaves(0), boxes.size());
}

TEST(BinnedSah, depth_is_bounded_on_places_that_double) {
    std::vector<Box3f> boxes;
    for (int i = 0; i < 3000; ++i) boxes.push_back(point_box(std::ldexp(1, i % 250 - 125), 0, 0));
    for (int i = 0; i < 250; ++i) {
        boxes.push_back(point_box(0, std::ldexp(1, -i / 2), 0));
        boxes.push_back({Vec3f::Zero(), Vec3f::Constant(std::ldexp(1.0f, i / 2 - 60))});
    }
    for (const std::uint32_t largest_leaf : {1, 4})
        expect_good_tree(boxes, {.largest_leaf = largest_leaf});
}

TEST(BinnedSah, any_extent_of_float_will_do) {
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

TEST(BinnedSah, extreme_and_empty_boxes_make_a_valid_tree) {
    const Vec3f largest = Vec3f::Constant(kLargest);
    std::vector<Box3f> boxes;
    for (int i = 0; i < 40; ++i) {
        boxes.push_back({-largest, largest});
        boxes.push_back({largest, largest});
        boxes.push_back({-largest, -largest});
        boxes.push_back({});
        boxes.push_back(point_box(i, i, i));
    }
    expect_good_tree(boxes);
    expect_good_tree(std::vector<Box3f>(100));
    expect_good_tree(std::vector<Box3f>(100, {-largest, largest}));
    expect_good_tree({{-largest, -largest}, {largest, largest}});
    expect_good_tree({});
    expect_good_tree({Box3f{}});
}

/// Not made by triangle_boxes(), but by a caller of build_tree(boxes).
TEST(BinnedSah, boxes_that_are_nan_keep_every_primitive) {
    std::vector<Box3f> boxes = triangle_boxes(generate_soup(200));
    const Vec3f nan = Vec3f::Constant(std::nanf(""));
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = {nan, nan};
    const Tree tree = build_binned_sah(boxes);
    std::vector<std::uint32_t> order = tree.order;
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(order[i], i);
}

}  // namespace
}  // namespace boxwood
