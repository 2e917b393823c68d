// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/reader_warnings.h"

namespace boxwood {

/// Counts the vertices that aren't finite among the mesh's warnings.
inline void warn_of_vertices(const std::string& file, MeshData& mesh) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3d& p = mesh.vertices[i];
        if (p.allFinite()) continue;
        mesh.warnings.add_lazily(kNotFinite, file, [&] {
            return std::pair(std::string(),
                             fmt::format("vertex {}: found ({}, {}, {}), expected finite numbers",
                                         i, p.x(), p.y(), p.z()));
        });
    }
}

}  // namespace boxwood
