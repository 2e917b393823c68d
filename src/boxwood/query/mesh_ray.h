// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/core/ray_crossing.h"
#include "boxwood/core/ray_triangle.h"
#include "boxwood/mesh/placed_mesh.h"

namespace boxwood {

/// A ray that is to be tested against triangles of a mesh, placed or not: the one meaning of "hit"
/// that every query shares, and the one of "crossing" that those share that count.
template <class Surface>
class MeshRay {
public:
    /// Precondition: is_traceable(ray).
    MeshRay(const Surface& surface, const Ray& ray) : surface_(surface), ray_(ray), sheared_(ray) {}

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
        const auto hit = test(surface_.corner(triangle, 0), surface_.corner(triangle, 1),
                              surface_.corner(triangle, 2));
        if (!hit || !is_in_float_range(surface_, triangle) || !stops(surface_, hit->from_front))
            return std::nullopt;
        return Hit{.t = hit->t, .u = hit->u, .v = hit->v, .triangle = triangle};
    }

    Surface surface_;
    const Ray& ray_;
    ShearedRay sheared_;
};

}  // namespace boxwood
