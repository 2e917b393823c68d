// SPDX-License-Identifier: Apache-2.0
// Which point of a triangle is nearest to another point? Where the point projects into the
// triangle, it is that projection; else it lies on an edge that the projection is beyond. Thin
// triangles, whose plane rounding may turn, try every edge, and the nearest of all these places
// counts: each is a place of the triangle, so rounding never finds one nearer than there is. A
// triangle of zero area is the segment or point that it covers. Constant time, no epsilon in the
// result. Source: Ericson, "Real-Time Collision Detection", 2005, section 5.1. Explained in
// docs/algorithms/closest_point.md.
#pragma once

#include <cstdint>
#include <limits>

#include "boxwood/core/vec.h"

namespace boxwood {

/// A part of a triangle (a, b, c), ends and edges left out of what they bound.
enum class TrianglePart : std::uint8_t {
    face,
    edge_ab,
    edge_bc,
    edge_ca,
    corner_a,
    corner_b,
    corner_c
};

/// The place (1 - u - v) a + u b + v c of a triangle, and how far a point is from it.
struct PlaceOnTriangle {
    double squared_distance = 0;
    double u = 0, v = 0;
    TrianglePart part = TrianglePart::face;
};

/// The place (1 - t) a + t b of a segment.
struct PlaceOnSegment {
    double squared_distance;
    double t;  ///< exactly 0 or 1 at an end
};

/// The place on the segment (a, b) that is nearest to the point. Seen from either end it is the
/// same, with the same bits of distance, so that the two triangles of an edge agree.
inline PlaceOnSegment nearest_place(const Vec3d& point, const Vec3d& a, const Vec3d& b) {
    const Vec3d to_a = a - point, to_b = b - point, along = b - a;
    const double from_a = -to_a.dot(along), from_b = to_b.dot(along);
    if (!(from_a > 0)) return {to_a.squaredNorm(), 0};
    if (!(from_b > 0)) return {to_b.squaredNorm(), 1};
    // Measured from the nearer end.
    const double length = along.squaredNorm();
    if (from_a == from_b) return {(0.5 * to_a + 0.5 * to_b).squaredNorm(), 0.5};
    if (from_a < from_b) {
        const double t = from_a / length;
        return {(to_a + t * along).squaredNorm(), t};
    }
    const double t = from_b / length;
    return {(to_b - t * along).squaredNorm(), 1 - t};
}

/// The place on the triangle (a, b, c) that is nearest to the point. With R the largest distance
/// between two of these four, it is no nearer than the exact one, but for 2^-48 R, and farther by
/// at most 2^-24 R, which only triangles thinner than that come near: others are right to 10^-12 R.
/// Two triangles of one edge or corner agree to the last bit on how far that is. Precondition: the
/// coordinates are finite and at most 1e150.
inline PlaceOnTriangle nearest_place(const Vec3d& point, const Vec3d& a, const Vec3d& b,
                                     const Vec3d& c) {
    const Vec3d ab = b - a, ac = c - a, from_a = point - a;
    const Vec3d normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    const double of_b = normal.dot(from_a.cross(ac)), of_c = normal.dot(ab.cross(from_a));
    const double of_a = area - of_b - of_c;

    // The square of the sine at a; beyond this, rounding of the weights is of no weight.
    constexpr double kThin = 1e-3;
    const bool is_thin = !(area > kThin * ab.squaredNorm() * ac.squaredNorm());
    // Nearer to an edge than this, rounding of the weights decides, so the edge is tried as well.
    const double at_edge = 1e-9 * area;
    const bool is_sure = (of_a > at_edge) & (of_b > at_edge) & (of_c > at_edge) & !is_thin;
    PlaceOnTriangle nearest = {std::numeric_limits<double>::infinity()};
    if ((of_a > 0) & (of_b > 0) & (of_c > 0)) {
        double u = of_b / area, v = of_c / area;
        Vec3d rest = from_a - u * ab - v * ac;
        if (is_thin) {
            // What the weights left along the triangle, weighed itself.
            const double more_u = u + normal.dot(rest.cross(ac)) / area;
            const double more_v = v + normal.dot(ab.cross(rest)) / area;
            if ((more_u >= 0) & (more_v >= 0) & (more_u + more_v <= 1)) {
                u = more_u;
                v = more_v;
                rest = from_a - u * ab - v * ac;
            }
        }
        nearest = {rest.squaredNorm(), u, v, TrianglePart::face};
        if (is_sure) return nearest;
    }
    const auto look_at_edge = [&](const Vec3d& from, const Vec3d& to, int edge) {
        const auto [squared_distance, t] = nearest_place(point, from, to);
        if (!(squared_distance < nearest.squared_distance)) return;
        nearest.squared_distance = squared_distance;
        nearest.u = edge == 0 ? t : edge == 1 ? 1 - t : 0;
        nearest.v = edge == 0 ? 0 : edge == 1 ? t : 1 - t;
        const int corner = t == 0 ? edge : t == 1 ? (edge + 1) % 3 : -1;
        nearest.part = static_cast<TrianglePart>(corner < 0 ? 1 + edge : 4 + corner);
    };
    if (is_thin | (of_c <= at_edge)) look_at_edge(a, b, 0);
    if (is_thin | (of_a <= at_edge)) look_at_edge(b, c, 1);
    if (is_thin | (of_b <= at_edge)) look_at_edge(c, a, 2);
    return nearest;
}

/// Where the place is. A corner is returned as it is, and an edge's places don't depend on the
/// triangle that they are seen from.
inline Vec3d place_at(const PlaceOnTriangle& place, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) {
    const auto between = [](const Vec3d& from, const Vec3d& to, double t) -> Vec3d {
        if (t <= 0.5) return from + t * (to - from);
        return to - (1 - t) * (to - from);
    };
    switch (place.part) {
        case TrianglePart::corner_a:
            return a;
        case TrianglePart::corner_b:
            return b;
        case TrianglePart::corner_c:
            return c;
        case TrianglePart::edge_ab:
            return between(a, b, place.u);
        case TrianglePart::edge_bc:
            return between(b, c, place.v);
        case TrianglePart::edge_ca:
            return between(a, c, place.v);
        default:
            return a + place.u * (b - a) + place.v * (c - a);
    }
}

}  // namespace boxwood
