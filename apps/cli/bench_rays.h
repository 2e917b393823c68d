// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "boxwood/core/ray.h"
#include "boxwood/scene/scene.h"

namespace boxwood::cli {

/// Rays of one kind, as a benchmark asks them.
struct RaySet {
    std::string_view name;
    bool any_hit;  ///< whether only the existence of a hit is asked for
    std::vector<Ray> rays;
};

/// Rays around a mesh, about the given number of each kind, the same each time:
/// primary, from a camera that sees the whole mesh; ambient occlusion, any hit, from what those see
/// into the half space above; random, between points of a sphere around the mesh.
std::vector<RaySet> make_ray_sets(const Scene& scene, std::size_t count);

}  // namespace boxwood::cli
