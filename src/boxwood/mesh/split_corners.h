// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/mesh/mesh_data.h"

namespace boxwood {

/// The same mesh for formats that have only vertices: normals, texture coordinates and colors of
/// corners or faces become those of vertices, and a vertex whose corners differ in them becomes as
/// many as it takes. Faces stay in order. Fields of vertices follow them. O(n log n).
/// Preconditions: check_indices(), check_attributes().
MeshData split_corners(MeshView mesh, const MeshAttributes& attributes);

}  // namespace boxwood
