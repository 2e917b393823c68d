// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/off/off_colors.h"
#include "boxwood/mesh/off/off_header.h"

namespace boxwood {

/// A vertex as an OFF file has it.
struct OffVertex {
    Vec3d position = Vec3d::Zero();
    double w = 1;
    Vec3f normal = Vec3f::Zero();
    OffColor color;
    Vec2f texture_coordinates = Vec2f::Zero();
};

/// What was met among the vertices of a part of a file.
struct OffVertices {
    float largest_color = 0;
    Warnings warnings = {};
};

/// Makes room in the mesh for the vertices and what they have.
void resize_off_vertices(const OffHeader& header, MeshData& mesh);

/// Puts a vertex into the mesh. Throws ParseError when its w is 0.
void set_off_vertex(const OffHeader& header, const std::string& file, const OffVertex& vertex,
                    std::size_t i, const OffPlace& place, MeshData& mesh, OffVertices& part);

}  // namespace boxwood
