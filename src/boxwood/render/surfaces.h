// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxwood/render/surface_finish.h"
#include "boxwood/scene/scene.h"
#include "boxwood/world/world.h"

namespace boxwood {

struct SurfaceHit {
    double t = 0;
    Vec3d point;
    Vec3d normal;          ///< geometric, of unit length, towards the front
    Vec3d shading_normal;  ///< that of the smooth surface which the mesh stands for, where known
    const Material* material = nullptr;
    Color color = Color::Ones();     ///< that multiplies the material's ambient and diffuse
    Color emission = Color::Zero();  ///< the light that it sends out itself
    double opacity = 1;
    TriangleId id;

    /// A ray that goes on from here. It doesn't see the triangle that it starts on, and starts off
    /// the surface by as much as the point may be rounded to its wrong side, so that a neighbour in
    /// the same plane doesn't catch it either.
    Ray ray_towards(const Vec3d& direction) const {
        const double rounding = 32 * 0x1p-52 * (point.lpNorm<Eigen::Infinity>() + t);
        const double side = direction.dot(normal) < 0 ? -1 : 1;
        return {.origin = point + side * rounding * normal, .direction = direction, .skip = id};
    }
};

/// One a ray, in order; nothing where it misses.
using SurfaceHits = std::vector<std::optional<SurfaceHit>>;

/// All that rays can hit in a world: its meshes, with their trees, and its spheres, which go by ids
/// as if they were the triangles of one more mesh.
class Surfaces {
public:
    /// The world must outlive it and stay as it is.
    explicit Surfaces(const World& world, const SceneOptions& options = {});

    std::optional<SurfaceHit> closest_hit(const Ray& ray, TraversalCounts* counts = nullptr) const;
    bool any_hit(const Ray& ray) const;

    // The same for each ray, on this thread: for a tile of a picture, or less.
    SurfaceHits closest_hits(std::span<const Ray> rays) const;
    std::vector<bool> any_hits(std::span<const Ray> rays) const;

    const Scene& scene() const { return scene_; }

private:
    std::optional<SurfaceHit> closest_of(const Ray& ray, const Hit& on_mesh,
                                         TraversalCounts* counts = nullptr) const;
    template <class Passes>
    std::optional<SurfaceFinish> first_that_stops(Ray ray, Hit& hit, const Passes& passes) const;
    bool hits_mesh(const Ray& ray, bool is_hit) const;
    bool hits_sphere(const Ray& ray) const;
    TriangleId sphere_id(std::uint32_t sphere) const;
    std::optional<double> intersect(const Ray& ray, std::uint32_t sphere, double t_max) const;

    const World& world_;
    Scene scene_;
    Tree sphere_tree_;
    bool has_unseen_places_ = false;  ///< that rays go through
    bool has_clear_places_ = false;   ///< that cast no shadow
};

}  // namespace boxwood
