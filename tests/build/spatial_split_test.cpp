// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/spatial_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "boxwood/build/binned_sah.h"
#include "boxwood/build/block_sah.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"
#include "laws/random.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

/// Every sampled point of every triangle is in a leaf of it, but for the rounding of the samples.
void expect_no_hole(const TriangleMesh& mesh, const Tree& tree) {
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    const MeshView view = mesh;
    std::vector<std::vector<Box3d>> leaves(mesh.faces.size());
    for (const Node& node : tree.nodes) {
        if (!node.is_leaf() || node.box.is_empty()) continue;
        for (const std::uint32_t i : tree.primitives(node))
            leaves[i].push_back({node.box.lo.cast<double>(), node.box.hi.cast<double>()});
    }
    Random random(1);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        if (boxes[i].is_empty()) continue;
        for (int sample = 0; sample < 20; ++sample) {
            double u = random.number(), v = random.number();
            if (u + v > 1) u = 1 - u, v = 1 - v;
            if (sample < 3) u = sample == 1, v = sample == 2;
            const Vec3d &a = view.corner(i, 0), &b = view.corner(i, 1), &c = view.corner(i, 2);
            const Vec3d point = (1 - u - v) * a + u * b + v * c;
            const Vec3d rounding = 0x1p-50 * (a.cwiseAbs() + b.cwiseAbs() + c.cwiseAbs());
            const Box3d around = {point - rounding, point + rounding};
            bool is_covered = false;
            for (const Box3d& leaf : leaves[i])
                is_covered |= (leaf.lo.array() <= around.hi.array()).all() &&
                              (around.lo.array() <= leaf.hi.array()).all();
            ASSERT_TRUE(is_covered) << "triangle " << i << " at " << point.transpose();
        }
    }
}

void expect_good_tree(const TriangleMesh& mesh, const SpatialSplitOptions& options = {}) {
    const Tree tree = build_spatial_split(mesh, options);
    ASSERT_EQ(find_fault_in_split_tree(tree, triangle_boxes(mesh)), std::nullopt);
    expect_no_hole(mesh, tree);
    const TreeStatistics found = statistics(tree);
    EXPECT_LE(found.largest_leaf, std::max(options.largest_leaf, options.block));
    const double most = options.replication * static_cast<double>(mesh.faces.size());
    EXPECT_LE(static_cast<double>(tree.order.size()), most);
    EXPECT_LE(static_cast<double>(found.depth), 41 + std::ceil(std::log2(std::max(most, 1.0))));
}

/// Long thin triangles across small ones.
TriangleMesh beams(int count) {
    TriangleMesh mesh = generate_torus_knot(static_cast<std::size_t>(10 * count));
    Random random(4);
    for (int i = 0; i < count; ++i) {
        const Vec3d a = random.point(-2, 2), along = 3 * random.direction();
        const int first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {a, a + along, Vec3d(a + along + 0.02 * random.direction())});
        mesh.faces.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

TEST(SpatialSplit, tree_is_good_for_every_mesh_and_option) {
    for (const MeshFamily& family : mesh_families()) {
        SCOPED_TRACE(family.name);
        const TriangleMesh mesh = family.make();
        expect_good_tree(mesh);
        expect_good_tree(mesh, {.replication = 4, .least_overlap = 0});
        expect_good_tree(mesh, {.replication = 1});
        expect_good_tree(mesh, {.largest_leaf = 1, .least_overlap = 0});
        expect_good_tree(mesh, {.largest_leaf = 16, .leaf_block = 8});
        expect_good_tree(mesh, {.replication = 4, .least_overlap = 0.01, .block = 16});
        expect_good_tree(mesh, {.largest_leaf = 8, .least_overlap = 1, .block = 4});
        for (const std::uint32_t run : {2, 4})
            expect_good_tree(mesh,
                             {.replication = 4, .least_overlap = 0.01, .block = 16, .run = run});
    }
}

TEST(SpatialSplit, long_triangles_are_split_and_the_tree_is_cheaper_for_it) {
    const TriangleMesh mesh = beams(300);
    const Tree tree = build_spatial_split(mesh);
    EXPECT_GT(tree.order.size(), mesh.faces.size());
    EXPECT_LT(statistics(tree).sah_cost,
              0.8 * statistics(build_binned_sah(triangle_boxes(mesh))).sah_cost);
}

TEST(SpatialSplit, tree_is_no_dearer_than_binned_sah_on_scans) {
    for (const TriangleMesh& mesh : {generate_gyroid(5000), generate_terrain(5000)}) {
        EXPECT_LT(statistics(build_spatial_split(mesh)).sah_cost,
                  1.01 * statistics(build_binned_sah(triangle_boxes(mesh))).sah_cost);
    }
}

TEST(SpatialSplit, replication_of_one_splits_nothing) {
    const TriangleMesh mesh = beams(100);
    const Tree tree = build_spatial_split(mesh, {.replication = 1});
    EXPECT_EQ(find_fault(tree, triangle_boxes(mesh)), std::nullopt);
}

TEST(SpatialSplit, leaves_fill_blocks) {
    const TriangleMesh mesh = generate_gyroid(5000);
    const auto leaves = [&](std::uint32_t block) {
        return statistics(build_spatial_split(mesh, {.largest_leaf = 8, .leaf_block = block}))
            .leaves;
    };
    EXPECT_LT(2 * leaves(8), leaves(1));
}

TEST(SpatialSplit, small_parts_are_those_of_block_sah) {
    const TriangleMesh mesh = beams(300);
    const SpatialSplitOptions options = {.least_overlap = 1e-3, .block = 16};
    const Tree tree = build_spatial_split(mesh, options);
    EXPECT_GT(tree.order.size(), mesh.faces.size());
    EXPECT_GT(statistics(tree).largest_leaf, options.largest_leaf);
    // Where all is small nothing is left to split.
    const TriangleMesh knot = generate_torus_knot(5000);
    EXPECT_TRUE(are_identical(build_spatial_split(knot, {.least_overlap = 1, .block = 16}),
                              build_block_sah(knot, {.block = 16})));
}

TEST(SpatialSplit, tree_is_the_same_for_any_number_of_threads) {
    const TriangleMesh mesh = beams(3000);
    std::vector<Tree> trees;
    for (const std::size_t threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        trees.push_back(build_spatial_split(mesh, {.least_overlap = 0}));
        trees.push_back(build_spatial_split(mesh, {.least_overlap = 1e-3, .block = 16, .run = 4}));
    }
    for (std::size_t i = 2; i < trees.size(); ++i)
        EXPECT_TRUE(are_identical(trees[i % 2], trees[i])) << i;
}

TEST(SpatialSplit, hits_are_those_of_brute_force_where_all_or_much_is_split) {
    const TriangleMesh mesh = beams(60);
    const Tree all = build_spatial_split(mesh, {.replication = 4, .least_overlap = 0});
    const Tree large =
        build_spatial_split(mesh, {.replication = 4, .least_overlap = 0.003, .block = 8, .run = 2});
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        const Ray ray = random_ray(mesh, seed);
        const auto expected = closest_hit_brute_force(mesh, ray);
        for (const Tree* tree : {&all, &large})
            ASSERT_TRUE(are_identical(closest_hit(mesh, *tree, ray), expected))
                << "seed " << seed << " " << testing::PrintToString(ray);
    }
}

TEST(SpatialSplit, many_triangles_in_a_plane_or_in_one_place_take_no_longer) {
    expect_good_tree(flat_grid(kIsSanitized ? 80 : 200));
    TriangleMesh mesh = generate_soup(1);
    mesh.faces.resize(cases(100'000), mesh.faces[0]);
    expect_good_tree(mesh);
}

TEST(SpatialSplit, options_out_of_range_are_refused) {
    const TriangleMesh mesh = generate_soup(10);
    EXPECT_THROW(build_spatial_split(mesh, {.largest_leaf = 0}), InvalidInput);
    EXPECT_THROW(build_spatial_split(mesh, {.leaf_block = 0}), InvalidInput);
    EXPECT_THROW(build_spatial_split(mesh, {.leaf_block = 3}), InvalidInput);
    for (const double replication : {0.5, 4.5, std::nan("")})
        EXPECT_THROW(build_spatial_split(mesh, {.replication = replication}), InvalidInput);
    for (const std::uint32_t run : {0, 3, 8})
        EXPECT_THROW(build_spatial_split(mesh, {.block = 16, .run = run}), InvalidInput);
    EXPECT_THROW(build_spatial_split(mesh, {.block = 257}), InvalidInput);
    EXPECT_THROW(build_spatial_split(mesh, {.block = 2, .run = 4}), InvalidInput);
    EXPECT_THROW(build_spatial_split({}, {.largest_leaf = 0}), InvalidInput);
}

}  // namespace
}  // namespace boxwood
