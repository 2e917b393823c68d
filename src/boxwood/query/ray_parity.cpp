// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/ray_parity.h"

#include <cmath>
#include <limits>

#include "boxwood/query/certified_hits.h"

namespace boxwood {

namespace {

/// Nothing for a ray that can't tell.
std::optional<bool> is_odd(MeshView mesh, const WideTree& tree, Ray ray) noexcept {
    // An edge is hit exactly when its weight is 0, but for the rounding of the weight.
    constexpr double kOnEdge = 1e-12;
    bool odd = false;
    while (const auto hit = closest_hit(mesh, tree, ray)) {
        if (std::min(std::min(hit->u, hit->v), 1 - hit->u - hit->v) < kOnEdge) return std::nullopt;
        Ray again = ray;
        again.t_min = again.t_max = hit->t;
        again.skip = {0, hit->triangle};
        if (any_hit(mesh, tree, again)) return std::nullopt;
        odd = !odd;
        ray.t_min = std::nextafter(hit->t, std::numeric_limits<double>::infinity());
    }
    return odd;
}

}  // namespace

std::optional<bool> is_inside_by_parity(MeshView mesh, const WideTree& tree,
                                        const Vec3d& point) noexcept {
    // Along no plane that people build in.
    static const Vec3d kDirections[] = {{0.6174, 0.3391, 0.7096},   {-0.2713, 0.8821, 0.3847},
                                        {0.4409, -0.1873, -0.8777}, {-0.7831, -0.5512, 0.2879},
                                        {0.1287, -0.9433, 0.3059},  {0.9172, 0.1759, -0.3574},
                                        {-0.3361, 0.2477, -0.9087}, {-0.5923, 0.7239, -0.3537}};
    for (const Vec3d& direction : kDirections) {
        if (const auto odd = is_odd(mesh, tree, {.origin = point, .direction = direction}))
            return odd;
    }
    return std::nullopt;
}

}  // namespace boxwood
