// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A tetrahedron, outside in front.
inline TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// The same triangles without a shared vertex.
inline TriangleMesh torn_apart(const TriangleMesh& mesh) {
    TriangleMesh result;
    for (const Vec3i& face : mesh.faces) {
        const int first = static_cast<int>(result.vertices.size());
        for (const int index : face)
            result.vertices.push_back(mesh.vertices[static_cast<std::size_t>(index)]);
        result.faces.emplace_back(first, first + 1, first + 2);
    }
    return result;
}

}  // namespace boxwood
