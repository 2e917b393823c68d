// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/build_wide_tree.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/collapse.h"
#include "boxwood/tree/validate.h"
#include "cases.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

std::vector<InstructionSet> supported_sets() {
    std::vector<InstructionSet> result;
    for (const auto& set : instruction_sets()) {
        if (is_supported(set.value)) result.push_back(set.value);
    }
    return result;
}

TEST(BuildPreset, trees_are_valid_for_every_width_and_the_wide_ones_stand_for_them) {
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        for (const auto& preset : build_presets()) {
            for (const InstructionSet set : supported_sets()) {
                SCOPED_TRACE(family.name + ", " + std::string(preset.name));
                const BuiltTree built =
                    build_preset(mesh, {.preset = preset.value, .instruction_set = set});
                ASSERT_EQ(find_fault_in_split_tree(built.tree, triangle_boxes(mesh)), std::nullopt);
                if (!built.wide.is_empty()) {
                    EXPECT_EQ(built.wide.cost(), collapsed_cost(built.tree, lanes(set)));
                }
            }
        }
    }
}

TEST(BuildPreset, best_is_balanced_where_no_triangle_is_large) {
    for (const TriangleMesh& mesh : {generate_gyroid(60'000), generate_terrain(20'000)}) {
        EXPECT_TRUE(are_identical(build_preset(mesh, {.preset = BuildPreset::best}).tree,
                                  build_preset(mesh, {.preset = BuildPreset::balanced}).tree));
    }
}

TEST(BuildPreset, best_is_cheaper_in_halls_and_dearer_nowhere) {
    const auto cost = [](const TriangleMesh& mesh, BuildPreset preset) {
        return collapsed_cost(build_preset(mesh, {.preset = preset}).tree,
                              lanes(preferred_instruction_set()));
    };
    const TriangleMesh stadium = generate_stadium(50'000);
    EXPECT_LT(cost(stadium, BuildPreset::best), 0.97 * cost(stadium, BuildPreset::balanced));
    for (const MeshFamily& family : mesh_families()) {
        const TriangleMesh mesh = family.make();
        EXPECT_LE(cost(mesh, BuildPreset::best), cost(mesh, BuildPreset::balanced)) << family.name;
    }
}

TEST(BuildPreset, trees_are_the_same_for_any_number_of_threads) {
    for (const TriangleMesh& mesh :
         {generate_stadium(cases(50'000)), generate_gyroid(cases(50'000))}) {
        for (const auto& preset : build_presets()) {
            std::vector<BuiltTree> built;
            for (const std::size_t threads : {1, 2, 5}) {
                const ThreadLimit limit(threads);
                built.push_back(build_preset(mesh, {.preset = preset.value}));
                const BuiltTree &first = built.front(), &last = built.back();
                EXPECT_TRUE(are_identical(first.tree, last.tree)) << preset.name << threads;
                ASSERT_EQ(first.wide.bytes(), last.wide.bytes()) << preset.name << threads;
                EXPECT_EQ(std::memcmp(first.wide.view().memory, last.wide.view().memory,
                                      first.wide.bytes()),
                          0)
                    << preset.name << threads;
            }
        }
    }
}

TEST(BuildPreset, nothing_makes_an_empty_tree) {
    for (const auto& preset : build_presets()) {
        const BuiltTree built = build_preset({}, {.preset = preset.value});
        EXPECT_TRUE(built.tree.is_empty());
        EXPECT_TRUE(built.wide.is_empty());
    }
}

}  // namespace
}  // namespace boxwood
