// SPDX-License-Identifier: Apache-2.0
// phong: what the camera sees directly, lit by ambient, diffuse and specular terms. Light passes
// through everything: no shadows, no mirrors. The pictures of the assignment look like this.
// Source: Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
#include "boxwood/render/phong.h"

namespace boxwood {

std::vector<Color> PhongIntegrator::radiances(std::span<const Ray> rays) const {
    std::vector<Color> colors(rays.size(), world_.background);
    const SurfaceHits hits = surfaces_.closest_hits(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        colors[i] = ambient_term(world_, *hits[i]);
        for (const PointLight& light : world_.lights)
            colors[i] += light_terms(light, *hits[i], towards_viewer(rays[i]));
    }
    return colors;
}

}  // namespace boxwood
