// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/build_wide_tree.h"

#include "boxwood/build/block_sah.h"
#include "boxwood/build/morton.h"
#include "boxwood/build/reinsertion.h"
#include "boxwood/build/spatial_split.h"

namespace boxwood {

namespace {

/// What a tree with split triangles has to save, as it is larger and fits less into the caches.
constexpr double kWorthSplitting = 0.97;

WideTree fast(MeshView mesh, const WideTreeOptions& options, std::uint32_t width) {
    return {mesh, build_morton(triangle_boxes(mesh), {.largest_leaf = width}), options};
}

WideTree balanced(MeshView mesh, const WideTreeOptions& options, std::uint32_t width) {
    Tree tree = build_block_sah(mesh, {.block = width});
    optimize_by_reinsertion(tree);
    return {mesh, tree, options};
}

WideTree with_splits(MeshView mesh, const WideTreeOptions& options, std::uint32_t width) {
    // Small leaves leave the collapse a choice of where blocks begin.
    const std::uint32_t leaf = width / 4;
    Tree tree = build_spatial_split(mesh, {.largest_leaf = leaf, .leaf_block = leaf});
    optimize_by_reinsertion(tree);
    return {mesh, tree, options};
}

}  // namespace

WideTree build_wide_tree(MeshView mesh, const WideBuildOptions& options) {
    const WideTreeOptions wide_options = {options.instruction_set};
    const auto width = static_cast<std::uint32_t>(lanes(options.instruction_set));
    if (options.preset == BuildPreset::fast) return fast(mesh, wide_options, width);
    WideTree whole = balanced(mesh, wide_options, width);
    if (options.preset == BuildPreset::balanced) return whole;
    // The cost of the wide tree tells which is faster; that of the binary one doesn't.
    WideTree split = with_splits(mesh, wide_options, width);
    return split.cost() < kWorthSplitting * whole.cost() ? std::move(split) : std::move(whole);
}

std::span<const Named<BuildPreset>> build_presets() {
    static constexpr Named<BuildPreset> kPresets[] = {
        {"fast", BuildPreset::fast},
        {"balanced", BuildPreset::balanced},
        {"best", BuildPreset::best},
    };
    return kPresets;
}

}  // namespace boxwood
