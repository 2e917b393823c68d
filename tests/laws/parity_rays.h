// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "laws/random.h"

namespace boxwood {

/// Rays that begin outside a ball around the mesh: aimed at vertices, at the middle of edges and at
/// anything; along edges; and parallel to axes through vertices and from the middle of edges, which
/// those meet exactly.
inline std::vector<Ray> rays_from_outside(MeshView mesh, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const Box3d box = bounds(mesh);
    const Vec3d center = box.centroid();
    const double radius = 0.51 * box.extent().norm();
    std::vector<Ray> rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t face = random.index(mesh.faces.size());
        const auto k = static_cast<int>(random.index(3));
        const Vec3d &a = mesh.corner(face, k), &b = mesh.corner(face, (k + 1) % 3);
        const Vec3d middle = 0.5 * (a + b);
        const Vec3d outside = center + 1.5 * radius * random.direction();
        const auto axis = static_cast<int>(random.index(3));
        const double sign = random.number() < 0.5 ? -1 : 1;
        const auto along_axis = [&](const Vec3d& through) {
            Ray ray = {.origin = through, .direction = Vec3d::Zero()};
            ray.origin[axis] = center[axis] - sign * 3 * radius;
            ray.direction[axis] = sign;
            return ray;
        };
        switch (i % 6) {
            case 0:
                rays.push_back({.origin = outside, .direction = a - outside});
                break;
            case 1:
                rays.push_back({.origin = outside, .direction = middle - outside});
                break;
            case 2:
                rays.push_back({.origin = outside, .direction = random.direction()});
                break;
            case 3: {
                // Beyond the ball, in whole lengths of the edge, so that little is rounded.
                const Vec3d edge = b - a;
                const double steps = edge.norm() > 0 ? std::ceil(3 * radius / edge.norm()) : 0;
                rays.push_back({.origin = a - steps * edge, .direction = edge});
                break;
            }
            case 4:
                rays.push_back(along_axis(a));
                break;
            default:
                rays.push_back(along_axis(middle));
        }
    }
    return rays;
}

}  // namespace boxwood
