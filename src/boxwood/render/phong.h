// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "boxwood/render/integrator.h"

namespace boxwood {

/// The Phong terms of a point that is seen from the direction to_viewer: ambient, plus diffuse and
/// specular from each light for which is_lit(to_light, distance) holds.
template <class IsLit>
Color phong_shading(const World& world, const SurfaceHit& hit, const Vec3d& to_viewer,
                    const IsLit& is_lit) {
    const Material& material = *hit.material;
    Color color = material.ambient.cwiseProduct(world.ambient);
    for (const PointLight& light : world.lights) {
        const Vec3d towards = light.position - hit.point;
        const Vec3d to_light = towards.normalized();
        if (!is_lit(to_light, towards.norm())) continue;
        const Vec3d half = (to_light + to_viewer).normalized();
        const double diffuse = std::max(to_light.dot(hit.normal), 0.0);
        const double specular = std::pow(std::max(hit.normal.dot(half), 0.0), material.shininess);
        color +=
            (material.diffuse * diffuse + material.specular * specular).cwiseProduct(light.color) /
            towards.squaredNorm();
    }
    return color;
}

class PhongIntegrator : public Integrator {
public:
    PhongIntegrator(const World& world, const Surfaces& surfaces)
        : world_(world), surfaces_(surfaces) {}

    Color radiance(const Ray& ray) const override;

private:
    const World& world_;
    const Surfaces& surfaces_;
};

}  // namespace boxwood
