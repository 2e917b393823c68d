// SPDX-License-Identifier: Apache-2.0
// Does a ray hit anything? The first hit found ends the walk, which is what a shadow ray needs.
// Explained in docs/algorithms/any_hit.md.
#include "boxwood/query/any_hit.h"

#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/traverse.h"

namespace boxwood {

bool any_hit(MeshView mesh, const Tree& tree, const Ray& ray) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return false;
    const MeshRay mesh_ray(mesh, ray);
    bool found = false;
    traverse(tree, ray, [&](std::uint32_t triangle, double t_max) {
        found = found || mesh_ray.intersect(triangle, t_max);
        return found ? kEndOfWalk : t_max;
    });
    return found;
}

}  // namespace boxwood
