// SPDX-License-Identifier: Apache-2.0
// normal: which way the surface faces, the unit normal's x, y and z from -1 to 1 as red, green and
// blue from 0 to 1. Where there is no surface it is black.
#include "boxwood/render/normal.h"

namespace boxwood {

std::vector<Color> NormalIntegrator::radiances(std::span<const Ray> rays) const {
    std::vector<Color> colors(rays.size(), Color::Zero());
    const SurfaceHits hits = surfaces_.closest_hits(rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hits[i]) colors[i] = 0.5 * (hits[i]->normal + Vec3d::Ones());
    return colors;
}

}  // namespace boxwood
