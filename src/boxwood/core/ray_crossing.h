// SPDX-License-Identifier: Apache-2.0
// Does a ray go through a surface here? The watertight test counts edges and vertices for each of
// their triangles, so that nothing leaks; who counts crossings needs each of them once. Here the
// ray is thought of as moved aside by e in x and e^2 in y of the sheared space, with an e smaller
// than any number. Then it meets no edge and no vertex, and goes through each surface once.
// Simulation of simplicity: Edelsbrunner and Muecke, ACM Transactions on Graphics 9(1), 1990.
// Constant time, no epsilon in numbers. Explained in docs/algorithms/all_hits.md.
#pragma once

#include <optional>

#include "boxwood/core/ray_triangle.h"

namespace boxwood {

/// The sign of the edge function p.x * q.y - p.y * q.x as the ray that is moved aside sees it:
/// that of the first difference from 0 in the power series in e. Swapping p and q swaps it. 0 only
/// where p and q are one place.
inline int side_of_edge(double px, double py, double qx, double qy) {
    const double edge = difference_of_products(px, qy, py, qx);
    if (edge != 0) return edge > 0 ? 1 : -1;
    if (py != qy) return py > qy ? 1 : -1;
    if (px != qx) return qx > px ? 1 : -1;
    return 0;
}

/// Whether the ray that is moved aside goes through the triangle. Never where the ray sees it
/// edge-on, exactly so after the shear: a triangle without area has no inside.
template <class Point = Vec3d>
bool goes_through(const ShearedRay& ray, const Point& a, const Point& b, const Point& c) {
    const double ax = ray.x(a), bx = ray.x(b), cx = ray.x(c);
    const double ay = ray.y(a), by = ray.y(b), cy = ray.y(c);
    const int side = side_of_edge(cx, cy, bx, by);
    return side != 0 && side == side_of_edge(ax, ay, cx, cy) &&
           side == side_of_edge(bx, by, ax, ay);
}

/// The hit of intersect() where the ray goes through the triangle; nothing where it only touches an
/// edge or a vertex whose crossing, if there is one, belongs to a neighbour. Of the triangles about
/// an edge or a vertex of a closed mesh, an even number is crossed on each whole line.
template <class Point = Vec3d>
std::optional<TriangleHit> crossing(const ShearedRay& ray, const Point& a, const Point& b,
                                    const Point& c, double t_min, double t_max) {
    const auto hit = intersect(ray, a, b, c, t_min, t_max);
    if (!hit || !goes_through(ray, a, b, c)) return std::nullopt;
    return hit;
}

}  // namespace boxwood
