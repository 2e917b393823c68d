// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/mesh/mesh_file.h"

namespace boxwood {

/// What assimp reads, an entry an extension; without writers. Only in a library built with
/// BOXWOOD_WITH_ASSIMP.
std::span<const MeshFormat> assimp_formats();

/// Reads a file by assimp, in the format that its extension names: all meshes where their nodes
/// stand, triangulated, with normals, the first texture coordinates and colours, and groups and
/// materials by name. Files that it names are opened by the rules of refusal_of(). Coordinates have
/// gone through float. Throws ParseError with what assimp says, and on limits. How well files are
/// checked that were made to do harm is up to assimp.
MeshData parse_by_assimp(const MeshSource& source, const ReadOptions& options = {});

}  // namespace boxwood
