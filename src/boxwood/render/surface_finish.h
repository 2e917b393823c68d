// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/scene/scene.h"
#include "boxwood/world/world.h"

namespace boxwood {

/// What a mesh's surface looks like at a place: its material, and what texture, vertices and the
/// side it is seen from make of that.
struct SurfaceFinish {
    const Material* material = nullptr;
    Vec3d normal;          ///< geometric
    Vec3d shading_normal;  ///< between those of the vertices, where they have some
    Color color = Color::Ones();
    Color emission = Color::Zero();
    double opacity = 1;  ///< 0 or 1 where the material has a cutoff
    bool is_seen = true;
};

/// At a hit of the ray on the scene that was made from the world's objects.
SurfaceFinish finish_at(const World& world, const Scene& scene, const Ray& ray, const Hit& hit);

}  // namespace boxwood
