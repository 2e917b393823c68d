// SPDX-License-Identifier: Apache-2.0
#include "ray_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/scene/scene.h"
#include "views.h"

namespace boxwood::bench {

namespace {

constexpr std::uint64_t kSeed = 3;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
// In radii of the ball around the mesh.
constexpr double kOffSurface = 1e-4;
constexpr double kAmbientOcclusionReach = 0.2;

struct Surface {
    Vec3d point, normal;  ///< the normal to the side that was seen
};

Vec3d on_sphere(std::uint64_t index, std::uint32_t dimension) {
    const double z = 2 * uniform(kSeed, index, dimension) - 1;
    const double angle = 2 * std::numbers::pi * uniform(kSeed, index, dimension + 1);
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

PlainRay plain(const Vec3d& from, const Vec3d& direction, float t_max = kInfinity) {
    const Vec3f o = from.cast<float>(), d = direction.cast<float>();
    return {o.x(), o.y(), o.z(), 0, d.x(), d.y(), d.z(), t_max};
}

/// Every second bit, closed up.
int even_bits(int x) {
    int result = 0;
    for (int bit = 0; bit < 16; ++bit) result |= (x >> (2 * bit) & 1) << bit;
    return result;
}

std::vector<PlainRay> primary_rays(const std::vector<Camera>& views, const RayOptions& options) {
    // Pictures of whole tiles.
    const int tile = std::max(options.tile, 1);
    const double pixels = static_cast<double>(options.count) / static_cast<double>(views.size());
    const int side = std::max(1, static_cast<int>(std::sqrt(pixels) / tile)) * tile;
    std::vector<PlainRay> rays;
    for (const Camera& camera : views) {
        const auto add = [&](int x, int y) {
            const Ray ray = camera.ray({.film = {x + 0.5, y + 0.5}}, side, side);
            rays.push_back(plain(ray.origin, ray.direction));
        };
        for (int y = 0; y < side; y += tile)
            for (int x = 0; x < side; x += tile)
                for (int i = 0; i < tile * tile; ++i) add(x + even_bits(i), y + even_bits(i >> 1));
    }
    return rays;
}

std::vector<Surface> seen_surface(const Scene& scene, const std::vector<PlainRay>& rays) {
    std::vector<Surface> all(rays.size());
    parallel_for(rays.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Ray ray = exact(rays[i]);
            const auto hit = scene.closest_hit(ray);
            if (!hit) continue;
            Vec3d normal = geometric_normal(scene.meshes()[0], hit->triangle);
            if (normal.dot(ray.direction) > 0) normal = -normal;
            all[i] = {ray.at(hit->t), normal};
        }
    });
    std::erase_if(all, [](const Surface& surface) { return surface.normal.isZero(); });
    return all;
}

/// Distributed as the cosine to the normal.
std::vector<PlainRay> rays_from(const std::vector<Surface>& surfaces, double radius, float t_max,
                                std::uint32_t dimension, std::size_t count) {
    std::vector<PlainRay> rays;
    for (std::size_t i = 0; i < count && !surfaces.empty(); ++i) {
        const Surface& from = surfaces[i * surfaces.size() / count];
        const Vec3d direction = from.normal + 0.999 * on_sphere(i, dimension);
        rays.push_back(
            plain(from.point + kOffSurface * radius * from.normal, direction.normalized(), t_max));
    }
    return rays;
}

std::vector<PlainRay> chords(const Vec3d& center, double radius, std::size_t count) {
    std::vector<PlainRay> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d from = center + radius * on_sphere(i, 0),
                    to = center + radius * on_sphere(i, 2);
        rays.push_back(plain(from, (to - from).normalized()));
    }
    return rays;
}

void find_truth(const Scene& scene, RaySet& set) {
    set.truth.assign(set.rays.size(), std::numeric_limits<double>::infinity());
    parallel_for(set.rays.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const auto hit = scene.closest_hit(exact(set.rays[i]))) set.truth[i] = hit->t;
    });
}

}  // namespace

std::string_view name_of(RayKind kind) {
    constexpr std::string_view kNames[] = {"primary", "ao", "diffuse", "random"};
    return kNames[static_cast<int>(kind)];
}

Ray exact(const PlainRay& ray) {
    return {.origin = {ray.ox, ray.oy, ray.oz},
            .direction = {ray.dx, ray.dy, ray.dz},
            .t_min = ray.t_min,
            .t_max = ray.t_max};
}

std::vector<RaySet> make_ray_sets(const BenchMesh& mesh, const std::vector<RayKind>& kinds,
                                  const RayOptions& options) {
    const Scene scene({mesh.exact});
    const Box3d box = bounds(mesh.exact);
    const Vec3d center = box.centroid();
    const double radius = box.extent().norm() / 2;
    const std::vector<PlainRay> primary = primary_rays(views_of(mesh.name, box), options);
    const std::vector<Surface> surfaces = seen_surface(scene, primary);

    std::vector<RaySet> sets;
    for (const RayKind kind : kinds) {
        RaySet set = {kind, {}, {}};
        if (kind == RayKind::primary) set.rays = primary;
        if (kind == RayKind::ao)
            set.rays =
                rays_from(surfaces, radius, static_cast<float>(kAmbientOcclusionReach * radius), 0,
                          options.count);
        if (kind == RayKind::diffuse)
            set.rays = rays_from(surfaces, radius, kInfinity, 2, options.count);
        if (kind == RayKind::random) set.rays = chords(center, radius, options.count);
        if (set.rays.empty()) continue;
        find_truth(scene, set);
        sets.push_back(std::move(set));
    }
    return sets;
}

}  // namespace boxwood::bench
