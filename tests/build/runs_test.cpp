// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "boxwood/build/block_sah.h"
#include "boxwood/build/morton.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/tree/statistics.h"
#include "boxwood/tree/validate.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// The same triangles in no order.
TriangleMesh shuffled(TriangleMesh mesh) {
    for (std::size_t i = mesh.faces.size(); i > 1; --i)
        std::swap(mesh.faces[i - 1], mesh.faces[mix_bits(i) % i]);
    return mesh;
}

Arena memory_for(const TriangleMesh& mesh) { return Arena(mesh.faces.size() * sizeof(Box3f)); }

Tree built_over_runs(const TriangleMesh& mesh, std::uint32_t length, std::uint32_t leaf) {
    const Arena memory = memory_for(mesh);
    const TriangleRuns runs(mesh, length, memory.bytes());
    return runs.over_triangles(build_block_sah(runs.boxes(), {.block = leaf / length}));
}

TEST(Runs, trees_over_them_are_valid_trees_over_the_triangles) {
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        const std::vector<Box3f> boxes = triangle_boxes(mesh);
        for (const std::uint32_t length : {1, 2, 4}) {
            SCOPED_TRACE(family.name + ", " + std::to_string(length));
            const Tree tree = built_over_runs(mesh, length, 16);
            ASSERT_EQ(find_fault(tree, boxes), std::nullopt);
            EXPECT_LE(statistics(tree).largest_leaf, 16u);
            const Arena memory = memory_for(mesh);
            const TriangleRuns runs(mesh, length, memory.bytes());
            const Tree morton = runs.over_triangles(build_morton(runs.boxes()));
            ASSERT_EQ(find_fault(morton, boxes), std::nullopt);
        }
    }
}

TEST(Runs, meshes_need_not_consist_of_whole_runs) {
    const TriangleMesh grid = flat_grid(3);
    for (std::size_t count = 0; count <= grid.faces.size(); ++count) {
        TriangleMesh mesh = grid;
        mesh.faces.resize(count);
        for (const std::uint32_t length : {2, 4}) {
            const Tree tree = built_over_runs(mesh, length, 8);
            ASSERT_EQ(find_fault(tree, triangle_boxes(mesh)), std::nullopt) << count;
        }
    }
}

TEST(Runs, those_that_nothing_hits_are_in_the_tree_and_in_no_box) {
    TriangleMesh mesh = flat_grid(32);
    mesh.vertices.push_back(Vec3d::Constant(std::nan("")));
    mesh.vertices.push_back(Vec3d::Constant(1e300));
    const int nan = static_cast<int>(mesh.vertices.size()) - 2;
    for (std::size_t i = 0; i < mesh.faces.size(); i += 3)
        mesh.faces[i][static_cast<int>(i / 3 % 3)] = nan + static_cast<int>(i % 2);
    for (const std::uint32_t length : {2, 4}) {
        const Tree tree = built_over_runs(mesh, length, 16);
        ASSERT_EQ(find_fault(tree, triangle_boxes(mesh)), std::nullopt);
    }
}

TEST(Runs, quads_side_by_side_are_runs_of_four_and_a_mesh_in_no_order_has_none) {
    const TriangleMesh grid = flat_grid(64);
    EXPECT_EQ(run_length(grid, 16), 4u);
    EXPECT_EQ(run_length(grid, 3), 2u);
    EXPECT_EQ(run_length(grid, 1), 1u);
    EXPECT_EQ(run_length(shuffled(grid), 16), 1u);
    EXPECT_EQ(run_length(generate_soup(2000), 16), 1u);
    EXPECT_EQ(run_length({}, 16), 1u);
    // However small or large the mesh is.
    for (const double scale : {1e-40, 1e-25, 1e25, 1e36}) {
        EXPECT_EQ(run_length(moved(grid, scale, Vec3d::Zero()), 16), 4u) << scale;
        EXPECT_EQ(run_length(moved(shuffled(grid), scale, Vec3d::Zero()), 16), 1u) << scale;
    }
}

TEST(Runs, pairs_are_taken_where_every_other_two_lie_apart) {
    // The quads of a row in two halves, which take turns.
    const TriangleMesh grid = flat_grid(64);
    TriangleMesh mesh = grid;
    const std::size_t half = grid.faces.size() / 4;
    for (std::size_t quad = 0; quad < half; ++quad) {
        for (std::size_t i = 0; i < 2; ++i) {
            mesh.faces[4 * quad + i] = grid.faces[2 * quad + i];
            mesh.faces[4 * quad + 2 + i] = grid.faces[2 * (half + quad) + i];
        }
    }
    EXPECT_EQ(run_length(mesh, 16), 2u);
}

/// Of each run, which a tree with a leaf for each tells.
void expect_boxes_no_larger_than_those_inside(const TriangleMesh& mesh) {
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    const Arena memory = memory_for(mesh);
    const TriangleRuns runs(mesh, 4, memory.bytes());
    const Tree tree = runs.over_triangles(build_block_sah(runs.boxes(), {.block = 1}));
    for (const Node& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        double of_each = 0;
        for (const std::uint32_t i : tree.primitives(node)) of_each += boxes[i].surface_area();
        EXPECT_LE(node.box.surface_area(), of_each * (1 + 1e-6));
    }
}

TEST(Runs, fours_whose_pairs_lie_apart_are_none) {
    TriangleMesh mesh;
    for (int row = 0; row < 4096; ++row) {
        for (const int x : {0, 2, 1, 3}) {
            const int first = static_cast<int>(mesh.vertices.size());
            for (const Vec3d& corner : {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)})
                mesh.vertices.push_back(corner + Vec3d(x, 2 * row, 0));
            mesh.faces.emplace_back(first, first + 1, first + 2);
        }
    }
    EXPECT_EQ(run_length(mesh, 16), 1u);
    const Arena memory = memory_for(mesh);
    const TriangleRuns of_mesh(mesh, 4, memory.bytes());
    std::vector<std::uint32_t> numbers(mesh.faces.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    const std::vector<Box3f> boxes = triangle_boxes(mesh);
    EXPECT_EQ(of_mesh.boxes().size(), mesh.faces.size());
    EXPECT_EQ(TriangleRuns(boxes, numbers, 4).boxes().size(), mesh.faces.size());
}

TEST(Runs, no_box_is_larger_than_those_inside) {
    for (const MeshFamily& family : mesh_families()) {
        SCOPED_TRACE(family.name);
        expect_boxes_no_larger_than_those_inside(family.make());
    }
}

TEST(Runs, no_box_is_larger_where_floats_end) {
    TriangleMesh mesh;
    mesh.vertices = {{-2e38, 0, 0},      {2e38, 1e30, 0},      {0, 1e30, 1e30},
                     {3e38, 3e38, 3e38}, {2.9e38, 3e38, 3e38}, {3e38, 2.9e38, 3e38}};
    mesh.faces = {{0, 1, 2}, {3, 4, 5}, {4, 5, 3}, {5, 3, 4}};
    expect_boxes_no_larger_than_those_inside(mesh);
}

TEST(Runs, what_nothing_hits_glues_nothing_together) {
    TriangleMesh mesh = generate_soup(2000);
    mesh.vertices.push_back(Vec3d::Constant(std::nan("")));
    for (std::size_t i = 0; i < mesh.faces.size(); i += 4)
        mesh.faces[i + mix_bits(i) % 4][0] = static_cast<int>(mesh.vertices.size()) - 1;
    expect_boxes_no_larger_than_those_inside(mesh);
}

TEST(Runs, of_some_triangles_are_those_of_the_mesh_as_far_as_these_go) {
    const TriangleMesh mesh = flat_grid(32);
    const std::vector<Box3f> all = triangle_boxes(mesh);
    for (const std::uint32_t length : {1, 2, 4}) {
        std::vector<Box3f> boxes;
        std::vector<std::uint32_t> numbers;
        std::size_t runs_there = 0;
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            // Some runs whole, some in part, some not at all.
            if (mix_bits(i / 4) % 3 == 0 || (mix_bits(i / 4) % 3 == 1 && mix_bits(i) % 2 == 0))
                continue;
            if (numbers.empty() || numbers.back() / length != i / length) ++runs_there;
            boxes.push_back(all[i]);
            numbers.push_back(i);
        }
        const TriangleRuns runs(boxes, numbers, length);
        // What lies on a grid lies together, unless its middle is missing.
        EXPECT_GE(runs.boxes().size(), runs_there);
        EXPECT_LE(static_cast<double>(runs.boxes().size()), 1.3 * static_cast<double>(runs_there));
        const Tree tree = runs.over_triangles(build_block_sah(runs.boxes(), {.block = 16}));
        EXPECT_EQ(find_fault(tree, boxes), std::nullopt);
    }
}

TEST(Runs, are_the_same_for_any_number_of_threads) {
    const TriangleMesh mesh = generate_interior(100'000);
    Tree first;
    for (const std::size_t threads : {1, 2, 3}) {
        const ThreadLimit limit(threads);
        Tree tree = built_over_runs(mesh, 4, 16);
        if (threads == 1)
            first = std::move(tree);
        else
            EXPECT_TRUE(are_identical(first, tree)) << threads;
    }
}

}  // namespace
}  // namespace boxwood
