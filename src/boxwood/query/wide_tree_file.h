// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

class OutputFile;

/// Writes the tree to a file that open_wide_tree() maps; docs/guide/saved_trees.md has its format.
/// The file appears whole or not at all. O(n). Throws InvalidInput when the mesh has another number
/// of faces than the tree was made for, and IoError. Precondition: the tree fits the mesh as it is.
void save_wide_tree(const WideTree& tree, MeshView mesh, const std::filesystem::path& path);

struct OpenTreeOptions {
    /// Don't read the tree, only what is in front of it: opens at once, and pages are read when a
    /// walk comes by. For files that nobody else can write and no disk has spoiled: a bad one may
    /// then make queries crash or loop.
    bool trust = false;
    /// The mesh lies in the same file: with trust it isn't hashed, and where it doesn't belong to
    /// the tree the file is corrupted.
    bool mesh_in_same_file = false;
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

// The same within a larger file, such as that of a scene.

/// Bytes of a file that is mapped: they stay as they are for as long as the owner lives.
struct PartOfFile {
    std::string name;  ///< what messages call it
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};

/// How long the file of a tree is.
std::size_t saved_bytes(const WideTree& tree);
/// Writes what save_wide_tree() does. Precondition: the file is a multiple of kSavedAlignment long.
void write_wide_tree(OutputFile& file, const WideTree& tree, MeshView mesh);
/// Precondition: the part begins at a multiple of kSavedAlignment in the file.
WideTree wide_tree_in(const PartOfFile& part, MeshView mesh, const OpenTreeOptions& options = {});

}  // namespace boxwood
