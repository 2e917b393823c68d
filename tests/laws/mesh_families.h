// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

struct MeshFamily {
    std::string name;
    TriangleMesh (*make)();
};
/// How tests that it is a parameter of are listed.
inline void PrintTo(const MeshFamily& family, std::ostream* out) { *out << family.name; }

/// Meshes of every kind that a builder or a query might stumble over, of up to about 2000
/// triangles.
const std::vector<MeshFamily>& mesh_families();

/// The surface of the cube [0, 1]^3 in n x n squares a side, n a power of two, so that all its
/// coordinates are exact. Closed.
TriangleMesh subdivided_cube(int n);

/// n x n squares in the plane z = 0 with corners at whole numbers.
TriangleMesh flat_grid(int n);

/// The mesh with all vertices p moved to scale * p + offset.
TriangleMesh moved(TriangleMesh mesh, double scale, const Vec3d& offset);

}  // namespace boxwood
