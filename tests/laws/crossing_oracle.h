// SPDX-License-Identifier: Apache-2.0
// Which triangles does a ray go through? Decided by the old way of counting the edges to the right
// of a point, half-open in y, with exact signs: the library never looks at it like this.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "boxwood/core/ray_triangle.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// The sign of a * b - c * d. Rounding keeps the order of products, so it matters only for two that
/// round to the same number, and by how much it moved each is exact.
inline int sign_of_difference(double a, double b, double c, double d) {
    const double ab = a * b, cd = c * d;
    if (ab != cd) return ab > cd ? 1 : -1;
    const double rest_of_ab = std::fma(a, b, -ab), rest_of_cd = std::fma(c, d, -cd);
    return static_cast<int>(rest_of_ab > rest_of_cd) - static_cast<int>(rest_of_ab < rest_of_cd);
}

/// Whether the triangle holds the point (e, e^2): an odd number of edges is to its right.
inline bool holds_moved_origin(const double (&x)[3], const double (&y)[3]) {
    bool inside = false;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if ((y[k] > 0) == (y[next] > 0)) continue;
        // Of the place where the edge meets the x axis; at 0 it is to the left of e.
        const int numerator = sign_of_difference(x[k], y[next], x[next], y[k]);
        if ((y[next] > y[k] ? numerator : -numerator) > 0) inside = !inside;
    }
    return inside;
}

inline std::vector<Hit> crossings_by_oracle(MeshView mesh, const Ray& ray) {
    std::vector<Hit> hits;
    if (!is_traceable(ray)) return hits;
    const ShearedRay sheared(ray);
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        if (i == ray.skip.triangle || triangle_box(mesh, i).is_empty()) continue;
        double x[3], y[3];
        for (int k = 0; k < 3; ++k) {
            x[k] = sheared.x(mesh.corner(i, k));
            y[k] = sheared.y(mesh.corner(i, k));
        }
        if (!holds_moved_origin(x, y)) continue;
        const auto hit = intersect(sheared, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2),
                                   ray.t_min, ray.t_max);
        if (hit) hits.push_back({.t = hit->t, .u = hit->u, .v = hit->v, .triangle = i});
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
    });
    return hits;
}

}  // namespace boxwood
