// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "boxwood/scene/scene.h"
#include "boxwood/world/world.h"

namespace boxwood {

struct SurfaceHit {
    double t = 0;
    Vec3d point;
    Vec3d normal;  ///< geometric, of unit length, towards the front
    const Material* material = nullptr;
    TriangleId id;  ///< for the skip of rays that go on from here
};

/// All that rays can hit in a world: its meshes, with their trees, and its spheres, which go by ids
/// as if they were the triangles of one more mesh.
class Surfaces {
public:
    /// The world must outlive it and stay as it is.
    explicit Surfaces(const World& world, const SceneOptions& options = {});

    std::optional<SurfaceHit> closest_hit(const Ray& ray, TraversalCounts* counts = nullptr) const;
    bool any_hit(const Ray& ray) const;

    const Scene& scene() const { return scene_; }

private:
    TriangleId sphere_id(std::uint32_t sphere) const;
    std::optional<double> intersect(const Ray& ray, std::uint32_t sphere, double t_max) const;

    const World& world_;
    Scene scene_;
    Tree sphere_tree_;
};

}  // namespace boxwood
