// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "boxwood/render/integrator.h"

namespace boxwood {

/// The unit direction from where the ray hits back along it.
inline Vec3d towards_viewer(const Ray& ray) { return -ray.direction.normalized(); }

/// What a surface shows of the light that is everywhere, and of its own.
inline Color ambient_term(const World& world, const SurfaceHit& hit) {
    return hit.material->ambient.cwiseProduct(hit.color).cwiseProduct(world.ambient) + hit.emission;
}

/// What a surface sends to a viewer in that direction of the light that it gets from a light:
/// Phong's diffuse and specular terms.
inline Color light_terms(const Light& light, const SurfaceHit& hit, const Vec3d& to_viewer) {
    const Material& material = *hit.material;
    const LightAt at = light_at(light, hit.point);
    const Vec3d half = (at.towards + to_viewer).normalized();
    const Vec3d& normal = hit.shading_normal;
    const double diffuse = std::max(at.towards.dot(normal), 0.0);
    const double specular = std::pow(std::max(normal.dot(half), 0.0), material.shininess);
    return (material.diffuse.cwiseProduct(hit.color) * diffuse + material.specular * specular)
               .cwiseProduct(light.color) /
           at.fall_off;
}

class PhongIntegrator : public Integrator {
public:
    PhongIntegrator(const World& world, const Surfaces& surfaces)
        : world_(world), surfaces_(surfaces) {}

    std::vector<Color> radiances(std::span<const Ray> rays) const override {
        return trace(rays, kMostLayers);
    }
    bool shows_light() const override { return true; }

private:
    /// Of what light shines through, one behind another.
    static constexpr int kMostLayers = 16;

    std::vector<Color> trace(std::span<const Ray> rays, int layers) const;

    const World& world_;
    const Surfaces& surfaces_;
};

}  // namespace boxwood
