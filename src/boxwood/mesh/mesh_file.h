// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "boxwood/mesh/attribute_names.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/mesh_source.h"

namespace boxwood {

/// A format of mesh files, with its reader and, unless it's null, its writer.
struct MeshFormat {
    std::string_view extension;  ///< ".off", in lower case
    std::string_view name;       ///< "Object File Format"
    MeshData (*parse)(const MeshSource& source, const ReadOptions& options);
    void (*write)(const std::filesystem::path& path, MeshView mesh,
                  const MeshAttributes& attributes);
    /// Whether the writer keeps an attribute; null without a writer.
    bool (*holds)(const AttributeName& attribute);
};

/// Those that Boxwood reads by itself.
std::span<const MeshFormat> mesh_formats();

/// The format that a file's extension names, in upper or lower case, with or without ".gz" behind
/// it; in a library built with assimp also one of those that only assimp reads. Throws InvalidInput
/// when there is none such.
const MeshFormat& mesh_format_of(const std::filesystem::path& path);

/// Reads a mesh file in the format that its extension names; files packed by gzip are unpacked.
/// Throws InvalidInput on an extension that no reader has, IoError, and ParseError with the place,
/// what was found and what was expected. What can be tolerated is told by the result's warnings.
MeshData read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes a mesh file in the format that its extension names, which appears whole or not at all.
/// Attributes that the format has no place for are left out. Throws InvalidInput on an extension
/// that no writer has and on what check_indices() and check_attributes() refuse, and IoError.
void write_mesh(const std::filesystem::path& path, MeshView mesh,
                const MeshAttributes& attributes = {});

}  // namespace boxwood
