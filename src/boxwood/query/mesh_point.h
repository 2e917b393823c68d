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

/// A point whose distances to triangles of a mesh are asked for, and the closest so far: the one
/// meaning of "closest" that every query shares.
class MeshPoint {
public:
    /// Precondition: is_near_anything(point, max_radius).
    MeshPoint(MeshView mesh, const Vec3d& point, double max_radius)
        : mesh_(mesh), point_(point), farthest_(max_radius) {}

    /// Precondition: a tree has a box for the triangle, see triangle_box().
    void offer(std::uint32_t triangle) {
        const PlaceOnTriangle place =
            nearest_place(point_, mesh_.corner(triangle, 0), mesh_.corner(triangle, 1),
                          mesh_.corner(triangle, 2));
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
        const Vec3d &a = mesh_.corner(triangle_, 0), &b = mesh_.corner(triangle_, 1),
                    &c = mesh_.corner(triangle_, 2);
        return {distance_, place_at(place_, a, b, c), place_.u, place_.v, triangle_, place_.part};
    }

private:
    MeshView mesh_;
    const Vec3d& point_;
    double farthest_;
    double distance_ = std::numeric_limits<double>::infinity();
    std::uint32_t triangle_ = TriangleId::kNone;
    PlaceOnTriangle place_;
};

inline double distance_to(MeshView mesh, std::uint32_t triangle, const Vec3d& point) {
    return std::sqrt(nearest_place(point, mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                                   mesh.corner(triangle, 2))
                         .squared_distance);
}

/// closest_point(), given one of another point, found or not: the nearer that point is, the sooner.
/// It doesn't show in the answer.
ClosestPoint closest_near(MeshView mesh, const WideTree& tree, const Vec3d& point,
                          double max_radius, const ClosestPoint& other) noexcept;

}  // namespace boxwood
