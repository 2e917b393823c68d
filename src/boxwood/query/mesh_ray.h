// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfloat>
#include <cstdint>
#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/core/ray_crossing.h"
#include "boxwood/core/ray_triangle.h"
#include "boxwood/mesh/placed_mesh.h"

namespace boxwood {

/// A triangle that a ray may hit, as a leaf of a tree has it.
struct Candidate {
    std::uint32_t triangle;
    /// Its corner [a, b, c][x, y, z], each `width` places behind the last one, if they are the
    /// mesh's own; null where they were rounded.
    const float* corners = nullptr;
    int width = 0;
};

/// A corner as a leaf has it.
struct BlockCorner {
    const float* first;
    int width;

    double operator[](int k) const { return first[k * width]; }
};

// What a mesh and a placed one make of a triangle that a leaf has.

inline const BlockCorner& placed_corner(const MeshView&, const BlockCorner& corner) {
    return corner;
}
inline Vec3d placed_corner(const PlacedMesh& placed, const BlockCorner& corner) {
    return placed.placement->to_world(Vec3d(corner[0], corner[1], corner[2]));
}
/// Leaves only have triangles in the range of float, but placing may take one out of it.
template <class Point>
bool stays_in_float_range(const MeshView&, const Point&) {
    return true;
}
inline bool stays_in_float_range(const PlacedMesh&, const Vec3d& corner) {
    return (corner.array().abs() <= FLT_MAX).all();
}

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

    // The same for what a tree's leaf says may be hit.

    std::optional<Hit> intersect(const Candidate& candidate, double t_max) const {
        return tested(candidate, [&](const auto& a, const auto& b, const auto& c) {
            return intersect_likely(sheared_, a, b, c, ray_.t_min, t_max);
        });
    }

    std::optional<Hit> crossing(const Candidate& candidate, double t_max) const {
        return tested(candidate, [&](const auto& a, const auto& b, const auto& c) {
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
        if (!hit || !is_in_float_range(surface_, triangle)) return std::nullopt;
        return on_this_side(*hit, triangle);
    }

    template <class Test>
    std::optional<Hit> tested(const Candidate& candidate, const Test& test) const {
        if (candidate.triangle == ray_.skip.triangle) return std::nullopt;
        const auto hit = with_corners(candidate, test);
        if (!hit) return std::nullopt;
        return on_this_side(*hit, candidate.triangle);
    }

    std::optional<Hit> on_this_side(const TriangleHit& hit, std::uint32_t triangle) const {
        if (!stops(surface_, hit.from_front)) return std::nullopt;
        return Hit{.t = hit.t, .u = hit.u, .v = hit.v, .triangle = triangle};
    }

    template <class Test>
    std::optional<TriangleHit> with_corners(const Candidate& candidate, const Test& test) const {
        const auto in_range = [&](const auto& a, const auto& b, const auto& c) {
            auto hit = test(a, b, c);
            if (hit && !(stays_in_float_range(surface_, a) && stays_in_float_range(surface_, b) &&
                         stays_in_float_range(surface_, c)))
                hit.reset();
            return hit;
        };
        if (candidate.corners == nullptr)
            return in_range(surface_.corner(candidate.triangle, 0),
                            surface_.corner(candidate.triangle, 1),
                            surface_.corner(candidate.triangle, 2));
        const auto corner = [&](int i) {
            return BlockCorner{candidate.corners + 3 * i * candidate.width, candidate.width};
        };
        return in_range(placed_corner(surface_, corner(0)), placed_corner(surface_, corner(1)),
                        placed_corner(surface_, corner(2)));
    }

    Surface surface_;
    const Ray& ray_;
    ShearedRay sheared_;
};

}  // namespace boxwood
