// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// Whether the ray hits anything in [ray.t_min, ray.t_max]: whether closest_hit() has an answer,
/// found sooner because any will do. Same rules, same precondition.
bool any_hit(MeshView mesh, const Tree& tree, const Ray& ray) noexcept;

}  // namespace boxwood
