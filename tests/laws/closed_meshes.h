// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "boxwood/mesh/generate.h"
#include "laws/mesh_families.h"

namespace boxwood {

struct ClosedMesh {
    std::string name;
    TriangleMesh mesh;
    double thickness;  ///< how far below its faces the inside reaches for sure
};

/// Of several shapes, as they are, a million times smaller, huge, and far from the origin.
inline std::vector<ClosedMesh> closed_meshes() {
    std::vector<ClosedMesh> meshes = {
        {"icosphere", generate_icosphere(1280), 0.5},
        {"torus_knot", generate_torus_knot(2000), 0.02},
        {"gyroid", generate_gyroid(3000), 0.005},
        {"cube", subdivided_cube(8), 0.25},
    };
    const auto unmoved = meshes.size();
    for (std::size_t i = 0; i < unmoved; ++i) {
        const auto [name, mesh, thickness] = meshes[i];
        meshes.push_back({name + "_tiny", moved(mesh, 1e-6, Vec3d::Zero()), 1e-6 * thickness});
        meshes.push_back({name + "_huge", moved(mesh, 1e8, Vec3d::Zero()), 1e8 * thickness});
        meshes.push_back({name + "_far_away", moved(mesh, 1, {1e8, -1e7, 1e8}), thickness});
    }
    return meshes;
}

}  // namespace boxwood
