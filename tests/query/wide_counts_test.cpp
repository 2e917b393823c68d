// SPDX-License-Identifier: Apache-2.0
// Counts where the right numbers are known, with every instruction set that this machine has.
#include "boxwood/query/wide_counts.h"

#include <gtest/gtest.h>

#include "boxwood/build/build.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {
namespace {

class WideCounting : public testing::TestWithParam<Named<InstructionSet>> {
protected:
    void SetUp() override {
        if (!is_supported(GetParam().value)) GTEST_SKIP() << "not on this machine";
    }

    WideTree tree_over(const TriangleMesh& mesh, bool compact = false) const {
        return {mesh,
                build_tree(mesh, {.method = BuildMethod::median}),
                {.instruction_set = GetParam().value, .compact = compact}};
    }

    std::uint64_t width() const { return lanes(GetParam().value); }
    // Where visits share no lines: nodes and blocks are of 8 and 10 arrays of 4 bytes a lane.
    std::uint64_t lines(std::uint64_t arrays) const { return (arrays * 4 * width() + 63) / 64; }
};

/// In the plane x = that, with corners (y, z) of (0, 0), (1, 0) and (0, 1).
void add_triangle(TriangleMesh& mesh, double x) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {Vec3d(x, 0, 0), Vec3d(x, 1, 0), Vec3d(x, 0, 1)});
    mesh.faces.emplace_back(first, first + 1, first + 2);
}

/// As many copies of a triangle at x = 0, and at x = 100, as a block holds: two boxes, far apart.
TriangleMesh two_blocks(std::uint64_t width) {
    TriangleMesh mesh;
    for (const double x : {0.0, 100.0})
        for (std::uint64_t i = 0; i < width; ++i) add_triangle(mesh, x);
    return mesh;
}

/// Along x, through all triangles at y = z = 0.25, through their boxes alone at 0.75.
Rayf along_x(float yz, float from = -1) {
    return {.origin = {from, yz, yz}, .direction = {1, 0, 0}};
}

WideCounts closest_counts(const WideTree& tree, const Rayf& ray) {
    WideCounts counts;
    Hitf hit;
    closest_hit(tree, ray, hit, counts);
    EXPECT_EQ(hit.triangle, closest_hit(tree, ray).value_or(Hitf{}).triangle);
    return counts;
}

WideCounts any_counts(const WideTree& tree, const Rayf& ray) {
    WideCounts counts;
    EXPECT_EQ(any_hit(tree, ray, counts), any_hit(tree, ray));
    return counts;
}

void expect_counts(const WideCounts& counts, std::uint64_t nodes, std::uint64_t boxes,
                   std::uint64_t blocks, std::uint64_t triangles) {
    EXPECT_EQ(counts.nodes, nodes);
    EXPECT_EQ(counts.boxes, boxes);
    EXPECT_EQ(counts.blocks, blocks);
    EXPECT_EQ(counts.triangles, triangles);
}

TEST_P(WideCounting, one_triangle_is_one_node_one_box_one_block) {
    TriangleMesh mesh;
    add_triangle(mesh, 0);
    const WideTree tree = tree_over(mesh);
    // One child, so its place is read but no order; the indices are for the closest hit alone.
    const WideCounts closest = closest_counts(tree, along_x(0.25f));
    expect_counts(closest, 1, 1, 1, 1);
    EXPECT_EQ(closest.lines, lines(7) + lines(10));
    const WideCounts any = any_counts(tree, along_x(0.25f));
    expect_counts(any, 1, 1, 1, 1);
    EXPECT_EQ(any.lines, lines(7) + lines(9));
}

TEST_P(WideCounting, a_compact_block_is_read_up_to_its_last_vertex) {
    TriangleMesh mesh;
    add_triangle(mesh, 0);
    const WideTree tree = tree_over(mesh, true);
    const std::uint64_t kVertices = 4;  // those of the triangle and the one of empty slots
    const std::uint64_t bytes = 7 * width() + 12 * kVertices;
    for (const float yz : {0.25f, 0.75f}) {
        for (const WideCounts& counts :
             {closest_counts(tree, along_x(yz)), any_counts(tree, along_x(yz))}) {
            expect_counts(counts, 1, 1, 1, 1);
            EXPECT_EQ(counts.lines, lines(7) + (bytes + 63) / 64);
        }
    }
}

TEST_P(WideCounting, a_ray_past_the_bounds_sees_the_boxes_of_the_root) {
    const WideTree tree = tree_over(two_blocks(width()));
    for (const WideCounts& counts :
         {closest_counts(tree, along_x(5)), any_counts(tree, along_x(5))}) {
        expect_counts(counts, 1, 2, 0, 0);
        EXPECT_EQ(counts.lines, lines(6));
    }
}

TEST_P(WideCounting, of_two_boxes_far_apart_the_second_is_left_out_behind_a_hit) {
    const WideTree tree = tree_over(two_blocks(width()));
    const WideCounts first = closest_counts(tree, along_x(0.25f));
    expect_counts(first, 1, 2, 1, width());
    EXPECT_EQ(first.lines, lines(8) + lines(10));
    expect_counts(any_counts(tree, along_x(0.25f)), 1, 2, 1, width());

    // From between them the ray meets one box, so it needs no order.
    const WideCounts second = closest_counts(tree, along_x(0.25f, 50));
    expect_counts(second, 1, 2, 1, width());
    EXPECT_GE(second.lines, lines(7) + lines(10));
    expect_counts(closest_counts(tree, along_x(0.75f)), 1, 2, 2, 2 * width());
    expect_counts(any_counts(tree, along_x(0.75f)), 1, 2, 2, 2 * width());
}

TEST_P(WideCounting, a_ray_through_all_boxes_counts_the_whole_tree) {
    TriangleMesh mesh;
    for (int i = 0; i < 1000; ++i) add_triangle(mesh, i);
    const WideTree tree = tree_over(mesh);
    for (const WideCounts& counts :
         {closest_counts(tree, along_x(0.75f)), any_counts(tree, along_x(0.75f))}) {
        EXPECT_GT(counts.nodes, 1u);
        EXPECT_EQ(counts.triangles, mesh.faces.size());
        EXPECT_EQ(counts.boxes, counts.nodes - 1 + counts.blocks) << "each has one parent";
        EXPECT_EQ(4 * width() * (8 * counts.nodes + 10 * counts.blocks), tree.bytes());
        // Some arrays are not read; where the width is 4, visits share lines.
        EXPECT_GE(counts.lines + counts.nodes + counts.blocks, tree.bytes() / 64);
        EXPECT_LE(counts.lines, tree.bytes() / 64 + counts.nodes + counts.blocks);
    }
    if (width() == 4) return;
    const WideCounts closest = closest_counts(tree, along_x(0.75f));
    EXPECT_EQ(closest.lines, closest.nodes * lines(8) + closest.blocks * lines(9));
    const WideCounts any = any_counts(tree, along_x(0.75f));
    EXPECT_EQ(any.lines, any.nodes * lines(7) + any.blocks * lines(9));
}

TEST_P(WideCounting, adds_up_and_counts_nothing_where_there_is_nothing_to_look_at) {
    const WideTree tree = tree_over(two_blocks(width()));
    WideCounts counts;
    Hitf hit;
    for (int i = 0; i < 3; ++i) closest_hit(tree, along_x(5), hit, counts);
    expect_counts(counts, 3, 6, 0, 0);

    const Rayf nowhere = {.direction = {0, 0, 0}};
    expect_counts(closest_counts(tree, nowhere), 0, 0, 0, 0);
    expect_counts(any_counts(WideTree(), along_x(0.25f)), 0, 0, 0, 0);
    EXPECT_EQ(closest_counts(WideTree(), along_x(0.25f)).lines, 0u);
}

INSTANTIATE_TEST_SUITE_P(Sets, WideCounting,
                         testing::ValuesIn(instruction_sets().begin(), instruction_sets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace boxwood
