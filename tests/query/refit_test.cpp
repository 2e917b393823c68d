// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/refit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "boxwood/build/block_sah.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/wide_fault.h"
#include "boxwood/query/write_block.h"

namespace boxwood {
namespace {

WideTree tree_over(const TriangleMesh& mesh, bool compact = false) {
    const auto width = static_cast<std::uint32_t>(lanes(preferred_instruction_set()));
    return WideTree(mesh, build_block_sah(mesh, {.block = width}), {.compact = compact});
}

bool have_same_bytes(const WideTree& a, const WideTree& b) {
    return a.bytes() == b.bytes() && std::memcmp(a.view().memory, b.view().memory, a.bytes()) == 0;
}

template <class Action>
std::string invalid_input_of(const Action& action) {
    try {
        action();
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "no InvalidInput";
}

TEST(Refit, restores_the_tree_when_all_is_back) {
    const TriangleMesh mesh = generate_torus_knot(20'000);
    TriangleMesh moved = mesh;
    for (Vec3d& vertex : moved.vertices) vertex = {vertex.z(), 2 * vertex.x(), -vertex.y()};
    for (const bool compact : {false, true}) {
        const WideTree built = tree_over(mesh, compact);
        WideTree tree = tree_over(mesh, compact);
        refit(tree, moved);
        EXPECT_FALSE(have_same_bytes(tree, built));
        refit(tree, mesh);
        EXPECT_TRUE(have_same_bytes(tree, built));
        EXPECT_EQ(tree.bounds(), built.bounds());
    }
}

TEST(Refit, is_the_same_on_any_number_of_threads) {
    TriangleMesh mesh = generate_gyroid(100'000);
    WideTree alone = tree_over(mesh), together = tree_over(mesh);
    for (Vec3d& vertex : mesh.vertices) vertex.x() += std::sin(9 * vertex.y());
    {
        const ThreadLimit limit(1);
        refit(alone, mesh);
    }
    refit(together, mesh);
    EXPECT_TRUE(have_same_bytes(alone, together));
    EXPECT_EQ(alone.cost(), together.cost());
}

TEST(Refit, tells_when_to_rebuild) {
    TriangleMesh mesh = generate_icosphere(5000);
    WideTree tree = tree_over(mesh);
    EXPECT_NEAR(refit(tree, mesh).ratio(), 1, 1e-5);
    for (Vec3d& vertex : mesh.vertices) vertex *= 3;
    EXPECT_NEAR(refit(tree, mesh).ratio(), 1, 1e-5);
    // What was side by side is now far apart.
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 2) mesh.vertices[i] *= -1;
    const RefitQuality quality = refit(tree, mesh);
    EXPECT_GT(quality.ratio(), 3);
    EXPECT_EQ(quality.cost, tree.cost());
    EXPECT_EQ(quality.cost_at_build, tree.parts().cost_at_build);
}

TEST(Refit, mesh_that_is_not_the_trees_leaves_the_tree_as_it_was) {
    const TriangleMesh mesh = generate_icosphere(500);
    WideTree tree = tree_over(mesh);
    const WideTree built = tree_over(mesh);
    TriangleMesh other = mesh;
    other.faces.pop_back();
    EXPECT_EQ(invalid_input_of([&] { refit(tree, other); }),
              "refit: the mesh has " + std::to_string(other.faces.size()) + " faces, expected " +
                  std::to_string(mesh.faces.size()) + " as in the tree");
    other = mesh;
    other.faces[17][2] = -1;
    EXPECT_EQ(invalid_input_of([&] { refit(tree, other); }).find("face 17 has vertex index -1"), 0);
    EXPECT_TRUE(have_same_bytes(tree, built));
}

TEST(Refit, triangle_without_a_place_cannot_come_back) {
    const TriangleMesh whole = generate_icosphere(500);
    TriangleMesh flawed = whole;
    flawed.vertices[flawed.faces[123][1]].y() = NAN;
    for (const bool compact : {false, true}) {
        WideTree tree = tree_over(flawed, compact);
        EXPECT_GE(tree.parts().left_out.size(), 5u);
        EXPECT_LE(tree.parts().left_out.size(), 6u);
        EXPECT_NE(invalid_input_of([&] { refit(tree, whole); }).find("has no place in the tree"),
                  std::string::npos);
        EXPECT_NEAR(refit(tree, flawed).ratio(), 1, 1e-5);
    }
    TriangleMesh nothing = whole;
    for (Vec3d& vertex : nothing.vertices) vertex.x() = INFINITY;
    WideTree empty = tree_over(nothing);
    EXPECT_EQ(empty.parts().left_out.size(), nothing.faces.size());
    EXPECT_EQ(refit(empty, nothing).ratio(), 1);
    EXPECT_THROW(refit(empty, whole), InvalidInput);
}

TEST(Refit, nothing_finite_left_is_an_empty_tree_until_it_is_back) {
    const TriangleMesh mesh = generate_icosphere(500);
    TriangleMesh nothing = mesh;
    for (Vec3d& vertex : nothing.vertices) vertex.x() = INFINITY;
    WideTree tree = tree_over(mesh);
    EXPECT_EQ(refit(tree, nothing).cost, 0);
    EXPECT_TRUE(tree.is_empty());
    refit(tree, mesh);
    EXPECT_FALSE(tree.is_empty());
    EXPECT_TRUE(closest_hit(mesh, tree, {.origin = {0, 0, 3}, .direction = {0, 0, -1}}));
}

TEST(Refit, leaf_without_triangles_stays_empty) {
    // As a file may have it.
    const TriangleMesh mesh = generate_soup(1);
    WideTree tree(mesh, build_block_sah(mesh), {.instruction_set = InstructionSet::scalar});
    WideTreeParts parts = tree.release();
    std::byte* memory = parts.memory.writable();
    const auto& root = *reinterpret_cast<const WideNode<4>*>(memory);
    auto& block = *reinterpret_cast<TriangleBlock<4>*>(memory + byte_offset(root.child[0]));
    std::fill_n(&block.corner[0][0][0], 36, std::nanf(""));
    std::fill_n(block.triangle, 4, kEmptySlot);
    parts.left_out = {0};
    ASSERT_EQ(find_fault(parts), std::nullopt);
    WideTree emptied(std::move(parts));
    TriangleMesh flawed = mesh;
    flawed.vertices[0].x() = std::nan("");
    refit(emptied, flawed);
    EXPECT_TRUE(emptied.bounds().is_empty());
}

TEST(Refit, empty_mesh_stays_empty) {
    WideTree tree({}, {}), fresh;
    EXPECT_EQ(refit(tree, {}).ratio(), 1);
    EXPECT_EQ(refit(fresh, {}).ratio(), 1);
}

TEST(Refit, compact_tree_without_room_for_other_faces_says_so) {
    const TriangleMesh mesh = generate_icosphere(5000);
    WideTree tree = tree_over(mesh, true);
    TriangleMesh soup = mesh;
    soup.vertices.clear();
    for (std::size_t i = 0; i < soup.faces.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            soup.faces[i][k] = static_cast<int>(soup.vertices.size());
            soup.vertices.push_back(mesh.vertices[mesh.faces[i][k]]);
        }
    }
    EXPECT_EQ(invalid_input_of([&] { refit(tree, soup); }),
              "refit: the faces aren't those that the tree was made for");
    EXPECT_TRUE(tree.is_empty());
    EXPECT_FALSE(any_hit(soup, tree, {.origin = {0, 0, 3}, .direction = {0, 0, -1}}));
}

}  // namespace
}  // namespace boxwood
