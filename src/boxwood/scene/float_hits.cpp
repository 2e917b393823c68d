// SPDX-License-Identifier: Apache-2.0
// Rays in float: by the kernels for many of them at a time where there is one tree to walk, else by
// way of double.
#include <algorithm>
#include <cfloat>

#include "boxwood/core/simd_scalar.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/kernels/ray_setup.h"
#include "boxwood/query/put_hit.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

namespace {

/// The largest float for what is beyond.
float nearest_float(double x) {
    return static_cast<float>(std::clamp(x, -double{FLT_MAX}, double{FLT_MAX}));
}

Ray in_double(const Rayf& ray) {
    Ray result;
    for (int k = 0; k < 3; ++k) {
        result.origin[k] = ray.origin[k];
        result.direction[k] = ray.direction[k];
    }
    result.t_min = ray.t_min;
    result.t_max = ray.t_max;
    return result;
}

/// The closest hit by way of double, with the normal that normal_of(id) gives.
template <class NormalOf>
Hitf closest_by_double(const Scene& scene, const Rayf& ray, const NormalOf& normal_of) {
    Hitf result;
    if (!is_traceable<Scalar>(ray)) return result;
    const auto hit = scene.closest_hit(in_double(ray));
    if (!hit) return result;
    result.t = nearest_float(hit->t);
    result.u = static_cast<float>(hit->u);
    result.v = static_cast<float>(hit->v);
    result.triangle = hit->triangle;
    result.instance = hit->instance;
    const Vec3d normal = normal_of(TriangleId{hit->instance, hit->triangle});
    for (int k = 0; k < 3; ++k) result.normal[k] = nearest_float(normal[k]);
    return result;
}

bool any_by_double(const Scene& scene, const Rayf& ray) {
    return is_traceable<Scalar>(ray) && scene.any_hit(in_double(ray));
}

/// Calls answer(i) for each of so many rays.
template <class Answer>
void for_each_ray(std::size_t count, const BatchOptions& options, const Answer& answer) {
    constexpr std::size_t kPiece = 256;
    for_each_piece(count, kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) answer(i);
    });
}

}  // namespace

const WideTree* Scene::only_tree() const {
    if (instances_.size() != 1 || wide_trees_.empty() || !placements_[0].is_identity())
        return nullptr;
    const Instance& instance = instances_[0];
    const bool is_plain = instance.visibility != 0 && !culls_back_faces(instance.mesh);
    return is_plain ? &wide_trees_[instance.mesh] : nullptr;
}

void Scene::closest_hits(std::span<const Rayf> rays, std::span<Hitf> hits,
                         const BatchOptions& options) const {
    if (const WideTree* tree = only_tree())
        return boxwood::closest_hits(*tree, rays, hits, options);
    check_hit_places(rays.size(), hits.size());
    const auto normal_of = [&](TriangleId id) { return area_normal(id); };
    for_each_ray(rays.size(), options,
                 [&](std::size_t i) { hits[i] = closest_by_double(*this, rays[i], normal_of); });
}

void Scene::closest_hits(const RayColumns& rays, const HitColumns& hits,
                         const BatchOptions& options) const {
    if (const WideTree* tree = only_tree())
        return boxwood::closest_hits(*tree, rays, hits, options);
    check_hit_places(rays.count, hits.count);
    const auto normal_of = [&](TriangleId id) { return geometric_normal(id); };
    for_each_ray(rays.count, options, [&](std::size_t i) {
        put_hit(hits, i, closest_by_double(*this, rays[i], normal_of));
    });
}

void Scene::any_hits(std::span<const Rayf> rays, std::span<bool> hits,
                     const BatchOptions& options) const {
    if (const WideTree* tree = only_tree()) return boxwood::any_hits(*tree, rays, hits, options);
    check_hit_places(rays.size(), hits.size());
    for_each_ray(rays.size(), options,
                 [&](std::size_t i) { hits[i] = any_by_double(*this, rays[i]); });
}

void Scene::any_hits(const RayColumns& rays, std::span<bool> hits,
                     const BatchOptions& options) const {
    if (const WideTree* tree = only_tree()) return boxwood::any_hits(*tree, rays, hits, options);
    check_hit_places(rays.count, hits.size());
    for_each_ray(rays.count, options,
                 [&](std::size_t i) { hits[i] = any_by_double(*this, rays[i]); });
}

}  // namespace boxwood
