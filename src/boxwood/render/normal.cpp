// SPDX-License-Identifier: Apache-2.0
// normal: which way the surface faces, the unit normal's x, y and z from -1 to 1 as red, green and
// blue from 0 to 1. Where there is no surface it is black.
#include "boxwood/render/normal.h"

namespace boxwood {

Color NormalIntegrator::radiance(const Ray& ray) const {
    const auto hit = surfaces_.closest_hit(ray);
    return hit ? Color(0.5 * (hit->normal + Vec3d::Ones())) : Color(Color::Zero());
}

}  // namespace boxwood
