// SPDX-License-Identifier: Apache-2.0
// whitted: phong with shadows, mirrors and glass. From each point that it sees it asks which lights
// are hidden, and follows the mirrored and the refracted ray in turn, up to a number of bounces.
// The rays of a tile go together: first all of them, then what they turn into at the surfaces. A
// ray doesn't see the triangle that it starts on, so no epsilon keeps it off its own surface.
// Source: Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980.
#include "boxwood/render/whitted.h"

#include "boxwood/render/onward_rays.h"
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

std::vector<Color> WhittedIntegrator::trace(std::span<const Ray> rays, int bounces) const {
    const SurfaceHits hits = surfaces_.closest_hits(rays);
    std::vector<Color> colors(rays.size(), world_.background);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hits[i]) colors[i] = ambient_term(world_, *hits[i]);
    for (const Light& light : world_.lights) add_light(light, rays, hits, colors);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hits[i]) colors[i] *= hits[i]->opacity;
    if (bounces == 0) return colors;

    const auto follow = [&](const auto& part_of, const auto& direction_of) {
        OnwardRays onward;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!hits[i] || part_of(*hits[i]).isZero(0)) continue;
            const Vec3d direction = direction_of(towards_viewer(rays[i]), *hits[i]);
            onward.add(hits[i]->ray_towards(direction), i);
        }
        if (onward.is_empty()) return;
        const std::vector<Color> seen = trace(onward.rays, bounces - 1);
        for (std::size_t k = 0; k < seen.size(); ++k) {
            const std::size_t i = onward.places[k];
            colors[i] += part_of(*hits[i]).cwiseProduct(seen[k]);
        }
    };
    follow([](const SurfaceHit& hit) -> Color { return hit.opacity * hit.material->mirror; },
           [](const Vec3d& to_viewer, const SurfaceHit& hit) {
               return reflected(to_viewer, hit.shading_normal);
           });
    follow([](const SurfaceHit& hit) -> Color { return hit.opacity * hit.material->refraction; },
           [](const Vec3d& to_viewer, const SurfaceHit& hit) {
               return refracted(to_viewer, hit.normal, hit.material->refraction_index);
           });
    follow([](const SurfaceHit& hit) -> Color { return Color::Constant(1 - hit.opacity); },
           [](const Vec3d& to_viewer, const SurfaceHit&) -> Vec3d { return -to_viewer; });
    return colors;
}

void WhittedIntegrator::add_light(const Light& light, std::span<const Ray> rays,
                                  const SurfaceHits& hits, std::vector<Color>& colors) const {
    OnwardRays shadow;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        const LightAt at = light_at(light, hits[i]->point);
        Ray ray = hits[i]->ray_towards(at.towards);
        ray.t_max = at.distance;
        shadow.add(ray, i);
    }
    const std::vector<bool> is_hidden = surfaces_.any_hits(shadow.rays);
    for (std::size_t k = 0; k < is_hidden.size(); ++k) {
        const std::size_t i = shadow.places[k];
        if (!is_hidden[k]) colors[i] += light_terms(light, *hits[i], towards_viewer(rays[i]));
    }
}

}  // namespace boxwood
