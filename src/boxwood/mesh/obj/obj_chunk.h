// SPDX-License-Identifier: Apache-2.0
// A part of an OBJ file. A first pass counts what every chunk defines, so that each knows how many
// vertices come before it, from which negative indices count. A second pass reads it.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/triangulate.h"

namespace boxwood {

/// How many vertices, texture coordinates and normals.
struct ObjCounts {
    std::size_t vertices = 0, texture_coordinates = 0, normals = 0;
};

/// From this face of the chunk on, faces bear the name.
struct ObjLabel {
    std::size_t face;
    std::string name;
};

struct ObjChunk {
    std::string_view text;
    std::size_t lines = 0, first_line = 0;
    ObjCounts counts, first;
    std::size_t polygons = 0;
    bool has_known_keyword = false;
    std::size_t first_unknown_line = 0;  ///< 0 when there is none
    std::string first_unknown_word;      ///< in quotes

    /// Where corners have no index, it is kNoIndex; where no corner of the chunk has, the array of
    /// texture coordinates or normals is empty.
    std::vector<Vec3i> faces, texture_faces, normal_faces;
    std::size_t first_face = 0;
    std::vector<PolygonFan> fans;
    /// Of all vertices of the chunk, kNoColor where there is none, or empty.
    std::vector<VertexColor> colors;
    std::vector<ObjLabel> groups, materials;
    std::vector<std::string> material_files;
    Warnings warnings;
};

constexpr int kNoIndex = -1;
inline const VertexColor kNoColor = VertexColor::Constant(std::numeric_limits<float>::quiet_NaN());

/// What all chunks read from and write to.
struct ObjBody {
    std::string name;
    std::size_t max_faces = 0;
    ObjCounts counts;
    std::span<Vec3d> vertices;
    std::vector<Vec2f> texture_coordinates;
    std::vector<Vec3f> normals;
};

/// Finds out the lines and counts of a chunk.
void count_obj_chunk(ObjChunk& chunk);

/// Reads the rest of it. Throws ParseError.
void read_obj_chunk(ObjChunk& chunk, ObjBody& body);

}  // namespace boxwood
