// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/core/limits.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/ply/ply_columns.h"
#include "boxwood/mesh/ply/ply_faces.h"
#include "boxwood/mesh/ply/ply_header.h"

namespace boxwood {

/// What the readers of text and of binary files share: what the elements mean, and what was read.
struct PlyBody {
    std::string name;       ///< of the file
    std::string_view text;  ///< the whole file
    PlyHeader header;
    std::size_t max_faces = 0;

    const PlyElement* vertices = nullptr;
    const PlyElement* faces = nullptr;   ///< null when there are none
    const PlyElement* strips = nullptr;  ///< likewise
    std::vector<PlyColumn> vertex_columns;
    std::vector<PlyColumn> face_columns;
    std::vector<std::size_t> face_numbers;  ///< the properties of faces that have columns
    std::optional<std::size_t> face_indices, face_texture_coordinates, strip_indices;

    MeshData mesh;
    bool has_faces = false;  ///< whether the faces are in the mesh already, all but strips
    std::atomic<bool> has_unfinite_vertices = false;

    bool is_needed(const PlyElement& element) const {
        return &element == vertices || &element == faces || &element == strips;
    }
    /// Room for the vertices and all that each has.
    void make_vertices() {
        bind_columns(vertex_columns, *vertices, ValuesOf::vertices, vertices->count, mesh);
    }
};

/// Whatever a part of the file holds of faces and strips.
struct PlyFaces {
    PlyFaceBatch polygons, strips;
    Warnings warnings;
};

/// Reads the body of a file in text. Fills in what belongs to vertices, and returns faces.
std::vector<PlyFaces> read_ply_text(PlyBody& body);

/// Reads the body of a binary file. Likewise, but where all faces are triangles of one size in the
/// file, they and what belongs to them are filled in as well.
std::vector<PlyFaces> read_ply_binary(PlyBody& body);

}  // namespace boxwood
