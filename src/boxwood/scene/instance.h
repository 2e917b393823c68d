// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <variant>

#include "boxwood/mesh/placement.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A mesh of a scene: views on arrays that somebody else owns.
struct SceneMesh {
    /// Vertices in float are widened into the scene's own memory, 24 bytes each.
    std::variant<MeshView, MeshViewf> geometry;
    /// Rays go through triangles that they meet from behind, where their corners turn clockwise.
    bool culls_back_faces = false;

    SceneMesh(MeshView mesh, bool culls = false) : geometry(mesh), culls_back_faces(culls) {}
    SceneMesh(MeshViewf mesh, bool culls = false) : geometry(mesh), culls_back_faces(culls) {}
    SceneMesh(const TriangleMesh& mesh, bool culls = false) : SceneMesh(MeshView(mesh), culls) {}
};

/// A mesh of a scene, moved. To rays it is what a mesh would be whose vertices were moved there by
/// Placement::to_world(); the fronts of its triangles go with it, even where the map mirrors.
struct Instance {
    std::uint32_t mesh = 0;  ///< its place among the scene's meshes
    AffineMap to_world = AffineMap::Identity();
    /// Rays see it whose own Ray::visibility has a bit of it.
    std::uint32_t visibility = ~std::uint32_t{0};
};
static_assert(sizeof(AffineMap) == 16 * sizeof(double) && alignof(AffineMap) == alignof(double));

}  // namespace boxwood
