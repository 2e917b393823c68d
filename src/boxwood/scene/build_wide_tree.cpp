// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/build_wide_tree.h"

#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "boxwood/build/block_sah.h"
#include "boxwood/build/morton.h"
#include "boxwood/build/reinsertion.h"
#include "boxwood/build/runs.h"
#include "boxwood/build/spatial_split.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/collapse.h"

namespace boxwood {

namespace {

/// What is smaller is left to the faster builder: the cost of rays stays within 1 percent of what
/// it is with a tenth or a twentieth of this, in 0.6 to 0.8 of the time.
constexpr double kLeastOverlap = 2e-3;

/// A guess from above at what a triangle takes in a fast tree, which is more than its box and two
/// keys to sort by: the same memory serves for both, as to touch it for the first time is a quarter
/// of the build. What isn't touched stays reserved, not used.
constexpr std::size_t kFastBytes = 72;

Tree fast(MeshView mesh, std::uint32_t width, std::span<std::byte> memory) {
    const std::uint32_t length = run_length(mesh, width);
    const std::size_t boxes = mesh.faces.size() * sizeof(Box3f);
    const TriangleRuns runs(mesh, length, memory.first(boxes));
    return runs.over_triangles(build_morton(
        runs.boxes(),
        {.largest_leaf = width / length, .full_leaves = true, .scratch = memory.subspan(boxes)}));
}

Tree balanced(MeshView mesh, std::uint32_t width) {
    const std::uint32_t length = run_length(mesh, width);
    Tree tree;
    if (length > 1) {
        const Arena memory(mesh.faces.size() * sizeof(Box3f));
        const TriangleRuns runs(mesh, length, memory.bytes());
        tree = runs.over_triangles(build_block_sah(runs.boxes(), {.block = width / length}));
    } else {
        tree = build_block_sah(mesh, {.block = width});
    }
    optimize_by_reinsertion(tree);
    return tree;
}

Tree with_splits(MeshView mesh, std::uint32_t width) {
    // Small leaves leave the collapse a choice of where blocks begin.
    const std::uint32_t leaf = width / 4;
    Tree tree = build_spatial_split(mesh, {.largest_leaf = leaf,
                                           .leaf_block = leaf,
                                           .least_overlap = kLeastOverlap,
                                           .block = width,
                                           .run = run_length(mesh, width)});
    optimize_by_reinsertion(tree);
    return tree;
}

/// Else no cut of triangles is worth it.
bool has_large_triangles(MeshView mesh, const Box3f& bounds) {
    constexpr std::size_t kPiece = 4096;
    const double least = kLeastOverlap * bounds.surface_area();
    return parallel_reduce(
        mesh.faces.size(), kPiece, false,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (triangle_box(mesh, i).surface_area() > least) return true;
            }
            return false;
        },
        std::logical_or<>());
}

/// The cost of the wide tree tells which is faster; that of the binary one doesn't.
Tree best(MeshView mesh, std::uint32_t width) {
    Tree whole = balanced(mesh, width);
    if (whole.is_empty() || !has_large_triangles(mesh, whole.root().box)) return whole;
    Tree split = with_splits(mesh, width);
    const int children = static_cast<int>(width);
    const bool pays = collapsed_cost(split, children) < collapsed_cost(whole, children);
    return pays ? std::move(split) : std::move(whole);
}

}  // namespace

BuiltTree build_preset(MeshView mesh, const WideBuildOptions& options) {
    const auto width = static_cast<std::uint32_t>(lanes(options.instruction_set));
    Arena memory;
    Tree tree;
    if (options.preset == BuildPreset::fast) {
        memory = Arena(mesh.faces.size() * kFastBytes);
        tree = fast(mesh, width, memory.bytes());
    } else if (options.preset == BuildPreset::best) {
        tree = best(mesh, width);
    } else {
        tree = balanced(mesh, width);
    }
    WideTree wide(mesh, tree,
                  {.instruction_set = options.instruction_set,
                   .compact = options.preset == BuildPreset::compact},
                  std::move(memory));
    return {std::move(tree), std::move(wide)};
}

WideTree build_wide_tree(MeshView mesh, const WideBuildOptions& options) {
    return build_preset(mesh, options).wide;
}

std::span<const Named<BuildPreset>> build_presets() {
    static constexpr Named<BuildPreset> kPresets[] = {
        {"fast", BuildPreset::fast},
        {"balanced", BuildPreset::balanced},
        {"compact", BuildPreset::compact},
        {"best", BuildPreset::best},
    };
    return kPresets;
}

}  // namespace boxwood
