// SPDX-License-Identifier: Apache-2.0
// What the numbers of vertices and faces mean is told by the names of their properties.
#pragma once

#include <cstddef>
#include <vector>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/ply/ply_header.h"

namespace boxwood {

enum class PlyRole { none, position, normal, texture_coordinate, color, field };

/// What stands for a whole number of a colour, from 0 to that most.
inline float ply_color(double value, double most) { return static_cast<float>(value / most); }

/// Where the values of one property go.
struct PlyColumn {
    PlyRole role = PlyRole::none;  ///< of lists, too
    int component = 0;
    double divisor = 1;  ///< of whole numbers that stand for 0 to 1

    double* doubles = nullptr;
    float* floats = nullptr;
    std::size_t stride = 1;

    void set(std::size_t i, double value) const {
        if (doubles) {
            doubles[i * stride] = value;
        } else if (floats) {
            floats[i * stride] = ply_color(value, divisor);
        }
    }
};

/// The roles of an element's properties, one column for each. Roles in the given set are taken by
/// another element: such properties become fields.
std::vector<PlyColumn> ply_columns(const PlyElement& element,
                                   const std::vector<PlyRole>& taken_roles = {});

bool has_role(const std::vector<PlyColumn>& columns, PlyRole role);

/// Makes room for that many values in the mesh and lets the columns point there.
void bind_columns(std::vector<PlyColumn>& columns, const PlyElement& element, ValuesOf of,
                  std::size_t count, MeshData& mesh);

}  // namespace boxwood
