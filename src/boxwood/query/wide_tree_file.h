// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// Writes the tree to a file that open_wide_tree() maps; docs/guide/saved_trees.md has its format.
/// The file appears whole or not at all. O(n). Throws InvalidInput when the mesh has another number
/// of faces than the tree was made for, and IoError. Precondition: the tree fits the mesh as it is.
void save_wide_tree(const WideTree& tree, MeshView mesh, const std::filesystem::path& path);

struct OpenTreeOptions {
    /// Don't read the tree, only what is in front of it: opens at once, and pages are read when a
    /// walk comes by. For files that nobody else can write and no disk has spoiled: a bad one may
    /// then make queries crash or loop.
    bool trust = false;
};

/// The tree as it lies in the file: pages are shared with all who opened it. It keeps the file
/// open, which nobody may write to meanwhile; saving to its path makes a new file and does no harm.
/// It is walked by the preferred instruction set, or, if that has another width, by the best one of
/// its width. O(n): reads the mesh and, without trust, the file.
///
/// Throws IoError, ParseError when the file is no saved tree, from a newer version, from a machine
/// of the other byte order, truncated or corrupted, and InvalidInput when it belongs to another
/// mesh or has a width that this machine can't walk.
WideTree open_wide_tree(const std::filesystem::path& path, MeshView mesh,
                        const OpenTreeOptions& options = {});

}  // namespace boxwood
