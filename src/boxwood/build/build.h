// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "boxwood/build/agglomerative.h"
#include "boxwood/core/named.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

// The index of the builders: one place that knows them all by name.

enum class BuildMethod {
    median,
    agglomerative,
    binned_sah,
    block_sah,
    morton,
    ploc,
    sweep_sah,
    spatial_split,
    reinsertion,  ///< spatial_split, and then optimize_by_reinsertion(): the cheapest tree
};

struct BuildOptions {
    BuildMethod method = BuildMethod::binned_sah;
    MergeCost cost = MergeCost::surface_area;  ///< of agglomerative
    std::uint32_t block = 4;                   ///< of block_sah: the width of the wide tree
};

/// A tree over the triangles of a mesh, as the method's own header describes it.
/// Precondition: indices in range.
Tree build_tree(MeshView mesh, const BuildOptions& options = {});

/// A tree over any boxes. Boxes can't be split, so binned_sah stands in for spatial_split.
Tree build_tree(std::span<const Box3f> boxes, const BuildOptions& options = {});

/// What to tell somebody who waits for it when a build will take minutes or more; else nothing.
std::optional<std::string> warning_before_build(std::size_t primitives,
                                                const BuildOptions& options);

std::span<const Named<BuildMethod>> build_methods();
std::span<const Named<MergeCost>> merge_costs();

}  // namespace boxwood
