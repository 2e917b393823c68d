// SPDX-License-Identifier: Apache-2.0
// Rays in float: by the kernels for many of them at a time where there is one tree to walk, else by
// way of double.
#include <algorithm>
#include <cfloat>

#include "boxwood/core/simd_scalar.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/kernels/ray_setup.h"
#include "boxwood/query/wide_hits.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 256;

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
    for_each_piece(rays.size(), kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            hits[i] = {};
            if (!is_traceable<Scalar>(rays[i])) continue;
            const auto hit = closest_hit(in_double(rays[i]));
            if (!hit) continue;
            hits[i].t = nearest_float(hit->t);
            hits[i].u = static_cast<float>(hit->u);
            hits[i].v = static_cast<float>(hit->v);
            hits[i].triangle = hit->triangle;
            hits[i].instance = hit->instance;
            const Vec3d normal = area_normal({hit->instance, hit->triangle});
            for (int k = 0; k < 3; ++k) hits[i].normal[k] = nearest_float(normal[k]);
        }
    });
}

void Scene::any_hits(std::span<const Rayf> rays, std::span<bool> hits,
                     const BatchOptions& options) const {
    if (const WideTree* tree = only_tree()) return boxwood::any_hits(*tree, rays, hits, options);
    check_hit_places(rays.size(), hits.size());
    for_each_piece(rays.size(), kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            hits[i] = is_traceable<Scalar>(rays[i]) && any_hit(in_double(rays[i]));
    });
}

}  // namespace boxwood
