// SPDX-License-Identifier: Apache-2.0
// phong: what the camera sees directly, lit by ambient, diffuse and specular terms. Light passes
// through everything: no shadows, no mirrors. The pictures of the assignment look like this.
// Source: Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
#include "boxwood/render/phong.h"

namespace boxwood {

Color PhongIntegrator::radiance(const Ray& ray) const {
    const auto hit = surfaces_.closest_hit(ray);
    if (!hit) return world_.background;
    const auto everywhere = [](const Vec3d&, double) { return true; };
    return phong_shading(world_, *hit, -ray.direction.normalized(), everywhere);
}

}  // namespace boxwood
