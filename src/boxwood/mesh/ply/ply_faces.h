// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/triangulate.h"

namespace boxwood {

/// A face as the file has it.
struct PlyPolygon {
    std::vector<int> corners;
    std::vector<float> texture_coordinates;  ///< two a corner
    std::vector<double> numbers;             ///< of all properties; lists have none
};

/// Triangles of a part of the file, in its order, and what belongs to each.
struct PlyFaceBatch {
    std::vector<Vec3i> faces;
    std::vector<PolygonFan> fans;
    /// Indices of texture_coordinates; empty when the faces have no such list.
    std::vector<Vec3i> texture_faces;
    std::vector<Vec2f> texture_coordinates;
    std::vector<std::vector<double>> numbers;  ///< of each property, one a triangle
    std::size_t first_face = 0;

    /// At least three corners. The numbers of those properties are kept that are in the list.
    void add(const PlyPolygon& polygon, std::span<const std::size_t> properties,
             bool has_texture_coordinates);

    /// Appends the triangles of a strip, which turn around alternately; -1 starts another strip.
    /// Returns how many had two equal corners and were left out.
    std::size_t add_strip(std::span<const int> indices);
};

}  // namespace boxwood
