// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxwood/core/random.h"
#include "boxwood/world/camera.h"

namespace boxwood::cli {

namespace {

constexpr std::uint64_t kSeed = 2;

Vec3d on_sphere(std::uint64_t index, std::uint32_t dimension) {
    const double z = 2 * uniform(kSeed, index, dimension) - 1;
    const double angle = 2 * std::numbers::pi * uniform(kSeed, index, dimension + 1);
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<Ray> primary_rays(const Vec3d& center, double radius, std::size_t count) {
    Camera camera;
    camera.look_at(center + Vec3d(0.5, 0.4, 1).normalized() * 2.6 * radius, center);
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))));
    std::vector<Ray> rays;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x)
            rays.push_back(camera.ray({.film = {x + 0.5, y + 0.5}}, side, side));
    }
    return rays;
}

std::vector<Ray> ambient_occlusion_rays(const Scene& scene, const std::vector<Ray>& primary,
                                        double radius, std::size_t count) {
    std::vector<Ray> starts;
    for (const Ray& ray : primary) {
        const auto hit = scene.closest_hit(ray);
        if (!hit) continue;
        Vec3d normal = scene.geometric_normal(*hit);
        if (normal.dot(ray.direction) > 0) normal = -normal;
        starts.push_back({.origin = ray.at(hit->t),
                          .direction = normal,
                          .t_max = radius,
                          .skip = {hit->instance, hit->triangle}});
    }
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count && !starts.empty(); ++i) {
        Ray ray = starts[i * starts.size() / count];
        ray.direction = (ray.direction + on_sphere(i, 0)).normalized();
        rays.push_back(ray);
    }
    return rays;
}

std::vector<Ray> random_rays(const Vec3d& center, double radius, std::size_t count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d from = center + radius * on_sphere(i, 2),
                    to = center + radius * on_sphere(i, 4);
        rays.push_back({.origin = from, .direction = (to - from).normalized()});
    }
    return rays;
}

}  // namespace

std::vector<RaySet> make_ray_sets(const Scene& scene, std::size_t count) {
    Box3d box;
    for (const MeshView& mesh : scene.meshes()) box.extend(bounds(mesh));
    if (box.is_empty()) return {};
    const Vec3d center = box.centroid();
    const double radius = 0.5 * box.extent().norm();

    std::vector<RaySet> sets;
    sets.push_back({"primary", false, primary_rays(center, radius, count)});
    sets.push_back(
        {"ambient occlusion", true, ambient_occlusion_rays(scene, sets[0].rays, radius, count)});
    sets.push_back({"random", false, random_rays(center, radius, count)});
    return sets;
}

}  // namespace boxwood::cli
