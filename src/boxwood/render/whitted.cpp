// SPDX-License-Identifier: Apache-2.0
// whitted: phong with shadows, mirrors and glass. From each point that it sees it asks which lights
// are hidden, and follows the mirrored and the refracted ray in turn, up to a number of bounces.
// A ray doesn't see the triangle that it starts on, so no epsilon keeps it off its own surface.
// Source: Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980.
#include "boxwood/render/whitted.h"

#include "boxwood/render/phong.h"

namespace boxwood {

namespace {

/// The direction that mirrors the one to the viewer.
Vec3d reflected(const Vec3d& to_viewer, const Vec3d& normal) {
    return 2 * normal.dot(to_viewer) * normal - to_viewer;
}

/// The direction in which light goes on through the surface by Snell's law; where the angle is too
/// flat for that, all of it is reflected.
Vec3d refracted(const Vec3d& to_viewer, const Vec3d& normal, double refraction_index) {
    const bool enters = normal.dot(to_viewer) > 0;
    const Vec3d n = enters ? normal : Vec3d(-normal);
    const double ratio = enters ? 1 / refraction_index : refraction_index;
    const double cos_in = n.dot(to_viewer);
    const double cos_out_squared = 1 - ratio * ratio * (1 - cos_in * cos_in);
    if (cos_out_squared < 0) return reflected(to_viewer, n);
    return (ratio * cos_in - std::sqrt(cos_out_squared)) * n - ratio * to_viewer;
}

}  // namespace

Color WhittedIntegrator::trace(const Ray& ray, int bounces) const {
    const auto hit = surfaces_.closest_hit(ray);
    if (!hit) return world_.background;

    const auto is_lit = [&](const Vec3d& to_light, double distance) {
        Ray shadow_ray = hit->ray_towards(to_light);
        shadow_ray.t_max = distance;
        return !surfaces_.any_hit(shadow_ray);
    };
    const Vec3d to_viewer = -ray.direction.normalized();
    Color color = phong_shading(world_, *hit, to_viewer, is_lit);
    if (bounces == 0) return color;

    const Material& material = *hit->material;
    if (!material.mirror.isZero(0)) {
        const Vec3d direction = reflected(to_viewer, hit->normal);
        color += material.mirror.cwiseProduct(trace(hit->ray_towards(direction), bounces - 1));
    }
    if (!material.refraction.isZero(0)) {
        const Vec3d direction = refracted(to_viewer, hit->normal, material.refraction_index);
        color += material.refraction.cwiseProduct(trace(hit->ray_towards(direction), bounces - 1));
    }
    return color;
}

}  // namespace boxwood
