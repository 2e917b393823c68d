// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "boxwood/scene/scene.h"

namespace boxwood {

/// Writes the scene, its meshes, instances and trees, to a file that open_scene() maps;
/// docs/guide/saved_trees.md has its format. The file appears whole or not at all. Trees as they
/// were built, that options.keep_trees keeps, are left out. O(n). Throws IoError, and InvalidInput
/// for a scene by brute force, which has nothing worth keeping. Precondition: vertices that moved
/// were refitted.
void save_scene(const Scene& scene, const std::filesystem::path& path);

struct OpenSceneOptions {
    /// Don't read meshes and trees, only what is in front of them: opens at once, and pages are
    /// read when a query comes by. For files that nobody else can write and no disk has spoiled: a
    /// bad one may then make queries crash or loop.
    bool trust = false;
};

/// The scene as it lies in the file, which it keeps open: pages are shared with all who opened it.
/// Nobody may write to the file meanwhile; saving to its path makes a new one and does no harm.
/// Trees are walked as open_wide_tree() says. O(n): reads the file, but with trust.
///
/// Throws IoError, ParseError when the file is no saved scene, from a newer version, from a machine
/// of the other byte order, truncated or corrupted, and InvalidInput when it has trees of a width
/// that this machine can't walk.
Scene open_scene(const std::filesystem::path& path, const OpenSceneOptions& options = {});

}  // namespace boxwood
