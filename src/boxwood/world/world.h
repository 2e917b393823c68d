// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "boxwood/core/vec.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/world/camera.h"

namespace boxwood {

/// Linear RGB.
using Color = Vec3d;

/// How a surface answers light, as in the assignment: Phong's terms plus mirror and refraction.
struct Material {
    Color ambient = Color::Zero();
    Color diffuse = Color::Zero();
    Color specular = Color::Zero();
    Color mirror = Color::Zero();
    Color refraction = Color::Zero();
    double refraction_index = 1;
    double shininess = 0;
};

/// A point light; what arrives at distance d is color / d^2.
struct PointLight {
    Vec3d position = Vec3d::Zero();
    Color color = Color::Zero();
};

struct Sphere {
    Vec3d center = Vec3d::Zero();
    double radius = 1;
    std::size_t material = 0;
};

struct MeshObject {
    TriangleMesh mesh;
    std::size_t material = 0;
};

/// Everything that a picture shows. Material indices are in range.
struct World {
    Color background = Color::Zero();
    Color ambient = Color::Zero();
    Camera camera;
    std::vector<Material> materials;
    std::vector<PointLight> lights;
    std::vector<Sphere> spheres;
    std::vector<MeshObject> meshes;
    Warnings warnings;  ///< what was wrong with files and tolerated
};

}  // namespace boxwood
