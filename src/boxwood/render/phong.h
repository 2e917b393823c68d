// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "boxwood/render/integrator.h"

namespace boxwood {

/// The unit direction from where the ray hits back along it.
inline Vec3d towards_viewer(const Ray& ray) { return -ray.direction.normalized(); }

/// What a surface shows of the light that is everywhere.
inline Color ambient_term(const World& world, const SurfaceHit& hit) {
    return hit.material->ambient.cwiseProduct(world.ambient);
}

/// What a surface sends to a viewer in that direction of the light that it gets from a point light:
/// Phong's diffuse and specular terms.
inline Color light_terms(const PointLight& light, const SurfaceHit& hit, const Vec3d& to_viewer) {
    const Material& material = *hit.material;
    const Vec3d towards = light.position - hit.point;
    const Vec3d to_light = towards.normalized();
    const Vec3d half = (to_light + to_viewer).normalized();
    const double diffuse = std::max(to_light.dot(hit.normal), 0.0);
    const double specular = std::pow(std::max(hit.normal.dot(half), 0.0), material.shininess);
    return (material.diffuse * diffuse + material.specular * specular).cwiseProduct(light.color) /
           towards.squaredNorm();
}

class PhongIntegrator : public Integrator {
public:
    PhongIntegrator(const World& world, const Surfaces& surfaces)
        : world_(world), surfaces_(surfaces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override;

private:
    const World& world_;
    const Surfaces& surfaces_;
};

}  // namespace boxwood
