// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cfloat>
#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/core/ray_crossing.h"
#include "boxwood/core/ray_triangle.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A ray that is to be tested against triangles of a mesh: the one meaning of "hit" that every
/// query shares, and the one of "crossing" that those share that count.
class MeshRay {
public:
    /// Precondition: is_traceable(ray).
    MeshRay(MeshView mesh, const Ray& ray) : mesh_(mesh), ray_(ray), sheared_(ray) {}

    std::optional<Hit> intersect(std::uint32_t triangle, double t_max) const {
        return tested(triangle, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
            return boxwood::intersect(sheared_, a, b, c, ray_.t_min, t_max);
        });
    }

    /// Nothing where the ray only touches the triangle: see core/ray_crossing.h.
    std::optional<Hit> crossing(std::uint32_t triangle, double t_max) const {
        return tested(triangle, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
            return boxwood::crossing(sheared_, a, b, c, ray_.t_min, t_max);
        });
    }

    const ShearedRay& sheared() const { return sheared_; }

private:
    template <class Test>
    std::optional<Hit> tested(std::uint32_t triangle, const Test& test) const {
        if (triangle == ray_.skip.triangle) return std::nullopt;
        const auto hit =
            test(mesh_.corner(triangle, 0), mesh_.corner(triangle, 1), mesh_.corner(triangle, 2));
        if (!hit || !is_in_float_range(triangle)) return std::nullopt;
        return Hit{.t = hit->t, .u = hit->u, .v = hit->v, .triangle = triangle};
    }

    /// Trees have no box for what lies beyond it: see triangle_boxes().
    bool is_in_float_range(std::uint32_t triangle) const {
        double largest = 0;
        for (int k = 0; k < 3; ++k)
            largest = std::max(largest, mesh_.corner(triangle, k).lpNorm<Eigen::Infinity>());
        return largest <= FLT_MAX;
    }

    MeshView mesh_;
    const Ray& ray_;
    ShearedRay sheared_;
};

}  // namespace boxwood
