// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxwood/core/vec.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// What values belong to. Corner k of face f, k from 0 to 2, has number 3 f + k.
enum class ValuesOf { vertices, faces, corners };

/// One value for each vertex, face or corner of a mesh; none at all when it's empty.
template <class Value>
struct MeshValues {
    ValuesOf of = ValuesOf::vertices;
    std::vector<Value> values;

    bool is_empty() const { return values.empty(); }
};

/// Red, green, blue and alpha, from 0 to 1, as a file has them.
using VertexColor = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;

/// A number for each vertex, face or corner, under a name: whatever was measured there.
struct MeshField {
    std::string name;
    ValuesOf of = ValuesOf::vertices;
    std::vector<double> values;
};

/// Which of some names each face bears; none at all when of_face is empty.
struct FaceLabels {
    std::vector<std::string> names;
    std::vector<std::uint32_t> of_face;  ///< indices of names

    bool is_empty() const { return of_face.empty(); }
};

/// What mesh files say of a mesh besides its triangles. Any of it may be missing.
struct MeshAttributes {
    MeshValues<Vec3f> normals;
    MeshValues<Vec2f> texture_coordinates;  ///< v grows upwards: (0, 0) is the lower left corner
    MeshValues<VertexColor> colors;
    std::vector<MeshField> fields;
    FaceLabels groups;
    FaceLabels materials;
    std::vector<std::string> material_files;  ///< that define the materials, as the file names them
};

/// All that was read from a mesh file.
struct MeshData : TriangleMesh {
    MeshAttributes attributes;
    Warnings warnings;
};

/// Throws InvalidInput, naming what doesn't fit, unless every attribute has one value for each of
/// what it belongs to, and labels are in range.
void check_attributes(MeshView mesh, const MeshAttributes& attributes);

}  // namespace boxwood
