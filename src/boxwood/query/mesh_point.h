// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "boxwood/query/closest_point.h"

namespace boxwood {

/// Whether a query for what is near the point has to look at all.
inline bool is_near_anything(const Vec3d& point, double max_radius) {
    constexpr double kFarthest = 1e150;
    return (point.array().abs() <= kFarthest).all() && max_radius >= 0;
}

/// A point whose distances to triangles of a mesh, placed or not, are asked for, and the closest so
/// far: the one meaning of "closest" that every query shares.
template <class Surface>
class MeshPoint {
public:
    /// Precondition: is_near_anything(point, max_radius).
    MeshPoint(const Surface& surface, const Vec3d& point, double max_radius)
        : surface_(surface), point_(point), farthest_(max_radius) {}

    /// Precondition: is_in_float_range(surface, triangle).
    void offer(std::uint32_t triangle) {
        const PlaceOnTriangle place =
            nearest_place(point_, surface_.corner(triangle, 0), surface_.corner(triangle, 1),
                          surface_.corner(triangle, 2));
        const double distance = std::sqrt(place.squared_distance);
        // In this order most are turned away by one comparison.
        if (distance > farthest_ || (distance == distance_ && triangle > triangle_)) return;
        farthest_ = distance_ = distance;
        triangle_ = triangle;
        place_ = place;
    }

    /// No triangle that is farther than this can be closest.
    double farthest() const { return farthest_; }

    ClosestPoint closest() const {
        if (triangle_ == TriangleId::kNone) return {};
        const Vec3d &a = surface_.corner(triangle_, 0), &b = surface_.corner(triangle_, 1),
                    &c = surface_.corner(triangle_, 2);
        ClosestPoint closest;
        closest.distance = distance_;
        closest.point = place_at(place_, a, b, c);
        closest.u = place_.u;
        closest.v = place_.v;
        closest.triangle = triangle_;
        closest.part = place_.part;
        return closest;
    }

private:
    Surface surface_;
    const Vec3d& point_;
    double farthest_;
    double distance_ = std::numeric_limits<double>::infinity();
    std::uint32_t triangle_ = TriangleId::kNone;
    PlaceOnTriangle place_;
};

template <class Surface>
double distance_to(const Surface& surface, std::uint32_t triangle, const Vec3d& point) {
    return std::sqrt(nearest_place(point, surface.corner(triangle, 0), surface.corner(triangle, 1),
                                   surface.corner(triangle, 2))
                         .squared_distance);
}

/// closest_point(), given one of another point, found or not: the nearer that point is, the sooner.
/// It doesn't show in the answer. For a Surface that is a MeshView or a PlacedMesh.
template <class Surface>
ClosestPoint closest_near(const Surface& surface, const WideTree& tree, const Vec3d& point,
                          double max_radius, const ClosestPoint& other) noexcept;

}  // namespace boxwood
