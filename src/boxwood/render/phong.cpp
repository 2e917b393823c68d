// SPDX-License-Identifier: Apache-2.0
// phong: what the camera sees directly, lit by ambient, diffuse and specular terms. Light passes
// through everything: no shadows, no mirrors. The pictures of the assignment look like this. What
// isn't quite opaque shows what is behind it as well.
// Source: Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
#include "boxwood/render/phong.h"

#include "boxwood/render/onward_rays.h"

namespace boxwood {

std::vector<Color> PhongIntegrator::trace(std::span<const Ray> rays, int layers) const {
    std::vector<Color> colors(rays.size(), world_.background);
    const SurfaceHits hits = surfaces_.closest_hits(rays);
    OnwardRays behind;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        colors[i] = ambient_term(world_, *hits[i]);
        for (const Light& light : world_.lights)
            colors[i] += light_terms(light, *hits[i], towards_viewer(rays[i]));
        if (hits[i]->opacity == 1) continue;
        colors[i] *= hits[i]->opacity;
        if (layers > 0) behind.add(hits[i]->ray_towards(rays[i].direction), i);
    }
    if (behind.is_empty()) return colors;
    const std::vector<Color> seen = trace(behind.rays, layers - 1);
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const std::size_t i = behind.places[k];
        colors[i] += (1 - hits[i]->opacity) * seen[k];
    }
    return colors;
}

}  // namespace boxwood
