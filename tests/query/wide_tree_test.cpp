// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/wide_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "boxwood/build/block_sah.h"
#include "boxwood/mesh/generate.h"
#include "rounded_to_float.h"

namespace boxwood {
namespace {

class WideTreeMemory : public testing::TestWithParam<Named<InstructionSet>> {
protected:
    /// Bytes a triangle of a tree over the mesh.
    static double bytes(const TriangleMesh& mesh, bool compact) {
        const InstructionSet set = GetParam().value;
        const Tree tree = build_block_sah(mesh, {.block = static_cast<std::uint32_t>(lanes(set))});
        const WideTree wide(mesh, tree, {.instruction_set = set, .compact = compact});
        EXPECT_EQ(wide.is_compact(), compact);
        return static_cast<double>(wide.bytes()) / static_cast<double>(mesh.faces.size());
    }
};

TEST_P(WideTreeMemory, stays_within_its_limits) {
    for (const char* shape : {"torus_knot", "interior", "gyroid"}) {
        const TriangleMesh mesh = generate(shape, 20'000);
        EXPECT_LE(bytes(mesh, false), 72) << shape;
        // Four triangles share few vertices.
        EXPECT_LE(bytes(mesh, true), lanes(GetParam().value) == 4 ? 50 : 40) << shape;
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, WideTreeMemory,
                         testing::ValuesIn(instruction_sets().begin(), instruction_sets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(WideTree, memory_that_is_spare_changes_nothing) {
    const TriangleMesh mesh = generate_gyroid(5000);
    const Tree tree = build_block_sah(mesh, {.block = 4});
    for (const auto& set : instruction_sets()) {
        for (const bool compact : {false, true}) {
            const WideTreeOptions options = {.instruction_set = set.value, .compact = compact};
            const WideTree expected(mesh, tree, options);
            for (const std::size_t bytes :
                 {expected.bytes() - 1, expected.bytes(), 3 * expected.bytes()}) {
                Arena spare(bytes);
                std::memset(spare.data(), 0xff, bytes);
                const WideTree wide(mesh, tree, options, std::move(spare));
                ASSERT_EQ(wide.bytes(), expected.bytes());
                EXPECT_EQ(std::memcmp(wide.view().memory, expected.view().memory, wide.bytes()), 0)
                    << set.name << compact;
            }
        }
    }
}

TEST(WideTree, has_exact_corners_where_all_vertices_are_floats) {
    const auto has = [](const TriangleMesh& mesh) {
        return WideTree(mesh, build_block_sah(mesh, {.block = 4})).has_exact_corners();
    };
    TriangleMesh mesh = generate_gyroid(5000);
    EXPECT_FALSE(has(mesh));
    mesh.vertices = rounded_to_float(mesh.vertices);
    EXPECT_TRUE(has(mesh));
    // What isn't finite is hit by nothing.
    Vec3d& last = mesh.vertices.back();
    last = {std::nan(""), std::numeric_limits<double>::infinity(), 1};
    EXPECT_TRUE(has(mesh));
    for (const double x : {1e39, 1e-50, 0.1, 1 + 0x1p-40}) {
        last = {0, x, 0};
        EXPECT_FALSE(has(mesh)) << x;
    }
    last = {0, 0, 0};
    for (Vec3d& vertex : mesh.vertices) vertex *= 0x1p60;
    EXPECT_FALSE(has(mesh)) << "it is scaled";
}

TEST(WideTree, over_nothing_is_empty) {
    for (const bool compact : {false, true}) {
        const TriangleMesh nothing, flaw = {{{0, 0, NAN}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
        EXPECT_TRUE(WideTree(nothing, {}, {.compact = compact}).is_empty());
        EXPECT_TRUE(WideTree(flaw, build_block_sah(flaw), {.compact = compact}).is_empty());
    }
}

}  // namespace
}  // namespace boxwood
