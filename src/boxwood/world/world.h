// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/core/vec.h"
#include "boxwood/core/warnings.h"
#include "boxwood/mesh/mesh_data.h"
#include "boxwood/mesh/placement.h"
#include "boxwood/world/camera.h"
#include "boxwood/world/color.h"
#include "boxwood/world/light.h"
#include "boxwood/world/material.h"
#include "boxwood/world/picture_settings.h"
#include "boxwood/world/texture.h"

namespace boxwood {

struct Sphere {
    Vec3d center = Vec3d::Zero();
    double radius = 1;
    std::size_t material = 0;
};

/// A mesh of the world, as it stands there and what it is made of.
struct MeshObject {
    std::size_t mesh = 0;
    /// One for all of it, or one for each of the mesh's material labels.
    std::vector<std::size_t> materials = {0};
    AffineMap to_world = AffineMap::Identity();
};

/// A camera that a file offers.
struct NamedCamera {
    std::string name = {};
    Camera camera = {};
    double aspect = 4.0 / 3;  ///< of the pictures it takes: width over height
};

/// Everything that a picture shows. Indices are in range.
struct World {
    Color background = Color::Zero();
    Color ambient = Color::Zero();
    Camera camera;
    std::vector<NamedCamera> cameras;  ///< to choose from, if there is a choice
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::vector<Sphere> spheres;
    std::vector<MeshData> meshes;
    std::vector<MeshObject> objects;
    PictureSettings picture;
    Warnings warnings;  ///< what was wrong with files and tolerated

    /// Adds a mesh and an object of it, where it is.
    void add_mesh(MeshData mesh, std::size_t material) {
        objects.push_back({.mesh = meshes.size(), .materials = {material}});
        meshes.push_back(std::move(mesh));
    }
    void add_mesh(TriangleMesh mesh, std::size_t material) {
        add_mesh(MeshData{std::move(mesh), {}, {}}, material);
    }
};

/// Makes one of its cameras the world's, with a picture of its shape and of the height that it has.
inline void use_camera(World& world, std::size_t i) {
    const NamedCamera& chosen = world.cameras.at(i);
    world.camera = chosen.camera;
    world.picture.width =
        std::max(1, static_cast<int>(std::lround(world.picture.height * chosen.aspect)));
}

}  // namespace boxwood
