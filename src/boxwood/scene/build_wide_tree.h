// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/core/named.h"
#include "boxwood/core/simd.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_tree.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// How long to build, for how fast rays.
enum class BuildPreset {
    fast,      ///< morton: for what moves
    balanced,  ///< block_sah, and reinsertion where it pays
    compact,   ///< balanced, in half the memory and with slower rays: for very large meshes
    best,      ///< spatial splits with reinsertion, where the cost of rays says that they pay
};

struct WideBuildOptions {
    BuildPreset preset = BuildPreset::balanced;
    InstructionSet instruction_set = preferred_instruction_set();
};

/// A tree as it was built, and the fast form that queries walk.
struct BuiltTree {
    Tree tree;
    WideTree wide;
};

/// The tree over the triangles of a mesh that the preset gives: the same for any number of threads.
/// O(n log n), all cores. Precondition: indices in range.
BuiltTree build_preset(MeshView mesh, const WideBuildOptions& options = {});

/// Its fast form alone.
WideTree build_wide_tree(MeshView mesh, const WideBuildOptions& options = {});

std::span<const Named<BuildPreset>> build_presets();

}  // namespace boxwood
