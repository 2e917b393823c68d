// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/random.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/scene/scene.h"
#include "boxwood/scene/scene_sign.h"
#include "laws/columns.h"
#include "laws/float_hits.h"
#include "laws/hits.h"
#include "laws/ray_families.h"

namespace boxwood {
namespace {

std::vector<Ray> some_rays(MeshView mesh, std::size_t count) {
    std::vector<Ray> rays;
    for (std::uint64_t seed = 0; seed < count; ++seed) rays.push_back(random_ray(mesh, seed));
    return rays;
}

std::vector<bool> any_hits(const Scene& scene, const std::vector<Ray>& rays,
                           const BatchOptions& options = {}) {
    const auto found = std::make_unique<bool[]>(rays.size());
    scene.any_hits(rays, {found.get(), rays.size()}, options);
    return std::vector<bool>(found.get(), found.get() + rays.size());
}

TEST(SceneBatch, answers_are_those_of_brute_force_in_order_for_any_count_and_threads) {
    const TriangleMesh mesh = generate_soup(300);
    const Scene scene({mesh});
    for (const std::size_t count : {0, 1, 2, 255, 256, 257, 3000}) {
        const std::vector<Ray> rays = some_rays(mesh, count);
        std::vector<std::optional<Hit>> expected;
        for (const Ray& ray : rays) expected.push_back(closest_hit_brute_force(mesh, ray));
        for (const std::size_t threads : {1, 2, 5}) {
            const ThreadLimit limit(threads);
            for (const bool here : {false, true}) {
                std::vector<Hit> hits(count, Hit{.t = -1, .triangle = 7, .instance = 9});
                scene.closest_hits(rays, hits, {.on_this_thread = here});
                const std::vector<bool> any = any_hits(scene, rays, {.on_this_thread = here});
                for (std::size_t i = 0; i < count; ++i) {
                    ASSERT_EQ(hits[i].is_hit(), expected[i].has_value()) << i;
                    ASSERT_TRUE(are_identical(hits[i], expected[i].value_or(Hit{}))) << i;
                    ASSERT_EQ(any[i], expected[i].has_value()) << i;
                }
            }
        }
    }
}

/// Whether kernels for many rays take them or not.
TEST(SceneBatch, rays_see_what_they_are_to_and_skip_in_their_instance_alone) {
    const TriangleMesh mesh = generate_icosphere(2000);
    Instance instance;
    instance.visibility = 2;
    const Scene scene({mesh}, {instance}, {});
    for (const std::uint64_t rare : {1, 5, 4000}) {
        std::vector<Ray> rays = some_rays(mesh, 3000);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = scene.closest_hit(rays[i]);
            rays[i].visibility = i % rare == 1 ? 1 : i % 2 == 0 ? 2 : 3;
            if (hit && i % 3 == 0) rays[i].skip = {i % rare == 2 ? 1u : 0u, hit->triangle};
        }
        std::vector<Hit> hits(rays.size());
        scene.closest_hits(rays, hits);
        const std::vector<bool> any = any_hits(scene, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto expected = scene.closest_hit(rays[i]);
            ASSERT_TRUE(are_identical(hits[i], expected.value_or(Hit{}))) << i;
            ASSERT_EQ(any[i], scene.any_hit(rays[i])) << i;
            if (i % rare == 1) ASSERT_FALSE(any[i]) << i;
        }
    }
}

TEST(SceneBatch, scene_of_nothing_is_never_hit) {
    const Scene scene({});
    const std::vector<Ray> rays(5);
    std::vector<Hit> hits(5, Hit{.t = 1, .triangle = 7, .instance = 9});
    scene.closest_hits(rays, hits);
    for (const Hit& hit : hits) EXPECT_TRUE(are_identical(hit, Hit{}));
    EXPECT_EQ(any_hits(scene, rays), std::vector<bool>(5, false));
}

TEST(SceneBatch, sizes_that_differ_are_refused) {
    const Scene scene({});
    const std::vector<Ray> rays(5);
    for (const std::size_t count : {0, 4, 6}) {
        std::vector<Hit> hits(count);
        const auto any = std::make_unique<bool[]>(count);
        EXPECT_THROW(scene.closest_hits(rays, hits), InvalidInput) << count;
        EXPECT_THROW(scene.any_hits(rays, {any.get(), count}), InvalidInput) << count;
        Columns columns(std::vector<Rayf>(5));
        HitColumns places = columns.hits();
        places.count = count;
        EXPECT_THROW(scene.closest_hits(columns.rays(), places), InvalidInput) << count;
        EXPECT_THROW(scene.any_hits(columns.rays(), {any.get(), count}), InvalidInput) << count;
    }
}

TEST(SceneBatch, can_be_watched_and_cancelled) {
    const ThreadLimit limit(1);  // or the others may do all before the first report
    const TriangleMesh mesh = generate_icosphere(100);
    const Scene scene({mesh});
    const std::vector<Ray> rays = some_rays(mesh, 10'000);
    std::vector<Hit> hits(rays.size());
    std::vector<double> parts;
    scene.closest_hits(rays, hits, {.progress = [&](double part) { parts.push_back(part); }});
    EXPECT_GT(parts.size(), 1u);
    EXPECT_EQ(parts.back(), 1);

    Cancellation cancellation;
    const BatchOptions options = {.progress = [&](double) { cancellation.request(); },
                                  .cancellation = &cancellation};
    EXPECT_THROW(scene.closest_hits(rays, hits, options), Cancelled);
    EXPECT_THROW(any_hits(scene, rays, options), Cancelled);
}

/// One mesh is asked by kernels for float, two by way of double.
TEST(SceneBatch, columns_can_be_watched_and_cancelled) {
    const ThreadLimit limit(1);  // or the others may do all before the first report
    const TriangleMesh mesh = generate_icosphere(100);
    for (const std::size_t meshes : {1, 2}) {
        const Scene scene(std::vector<SceneMesh>(meshes, SceneMesh(mesh)));
        std::vector<Rayf> rays;
        for (const Ray& ray : some_rays(mesh, 100'000)) rays.push_back(in_float(ray));
        Columns columns(rays);
        std::vector<double> parts;
        const BatchOptions watched = {.progress = [&](double part) { parts.push_back(part); }};
        scene.closest_hits(columns.rays(), columns.hits(), watched);
        EXPECT_GT(parts.size(), 1u);
        EXPECT_EQ(parts.back(), 1);
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));

        Cancellation cancellation;
        const BatchOptions options = {.progress = [&](double) { cancellation.request(); },
                                      .cancellation = &cancellation};
        EXPECT_THROW(scene.closest_hits(columns.rays(), columns.hits(), options), Cancelled);
        EXPECT_THROW(scene.any_hits(columns.rays(), columns.any(), options), Cancelled);
    }
}

/// By kernels for float where there is one mesh, by way of double where there are two.
TEST(SceneBatch, rays_in_float_find_what_those_in_double_find) {
    const TriangleMesh mesh = generate_icosphere(2000);
    Instance beside;
    beside.to_world.translate(Vec3d(1.5, 0, 0)).scale(Vec3d(-1, 1, 1));
    std::vector<Rayf> rays;
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const auto number = [&](std::uint32_t k) {
            return static_cast<float>(uniform(1, i, k)) - 0.5f;
        };
        rays.push_back(
            {.origin = {3 * number(0), 3 * number(1), 4}, .direction = {number(2), number(3), -2}});
    }
    for (const std::vector<Instance>& instances : {std::vector<Instance>(1), {beside, {}}}) {
        for (const bool brute_force : {false, true}) {
            const Scene scene({mesh}, instances, {.brute_force = brute_force});
            std::vector<Hitf> hits(rays.size(), Hitf{.t = -1, .triangle = 3, .instance = 9});
            const auto any = std::make_unique<bool[]>(rays.size());
            scene.closest_hits(rays, hits);
            scene.any_hits(rays, {any.get(), rays.size()});
            std::size_t found = 0, same = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                Ray ray;
                for (int k = 0; k < 3; ++k) {
                    ray.origin[k] = rays[i].origin[k];
                    ray.direction[k] = rays[i].direction[k];
                }
                const auto expected = scene.closest_hit(ray);
                ASSERT_EQ(hits[i].is_hit(), any[i]) << i;
                if (!expected || !hits[i].is_hit()) continue;
                ++found;
                // Next to an edge the neighbour may be hit, and nearly edge-on t is less certain.
                same += hits[i].triangle == expected->triangle;
                ASSERT_EQ(hits[i].instance, expected->instance) << i;
                ASSERT_NEAR(hits[i].t, expected->t, 1e-3) << i;
                const Vec3d normal = scene.geometric_normal(*expected);
                const Vec3f in_float = Eigen::Map<const Vec3f>(hits[i].normal).normalized();
                if (hits[i].triangle == expected->triangle)
                    ASSERT_LE((in_float.cast<double>() - normal).norm(), 1e-3) << i;
            }
            EXPECT_GT(found, 700u);
            EXPECT_GE(same + 5, found);

            Columns columns(rays);
            scene.closest_hits(columns.rays(), columns.hits());
            EXPECT_TRUE(columns.hold(hits));
            scene.any_hits(columns.rays(), columns.any());
            EXPECT_TRUE(std::equal(any.get(), any.get() + rays.size(), columns.any().begin()));
        }
    }
}

TEST(SceneBatch, distances_can_be_watched_and_cancelled) {
    const ThreadLimit limit(1);  // or the others may do all before the first report
    const TriangleMesh mesh = generate_icosphere(100);
    const Scene scene({mesh});
    const SceneSign sign(scene, SignMethod::winding_number);
    const std::vector<Vec3d> points(300'000, Vec3d(0.5, 0.25, 2));
    const std::vector<Box3d> boxes(1000, Box3d{{0, 0, 0}, {1, 1, 1}});
    std::vector<ClosestPoint> closest(points.size());
    std::vector<SignedDistance> distances(points.size());
    std::vector<double> numbers(points.size());
    std::vector<double> parts;
    scene.closest_points(points, closest, HUGE_VAL,
                         {.progress = [&](double part) { parts.push_back(part); }});
    EXPECT_GT(parts.size(), 10u);
    EXPECT_LE(parts.size(), 1100u);
    EXPECT_EQ(parts.back(), 1);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));

    Cancellation cancellation;
    const BatchOptions options = {.progress = [&](double) { cancellation.request(); },
                                  .cancellation = &cancellation};
    EXPECT_THROW(scene.closest_points(points, closest, HUGE_VAL, options), Cancelled);
    EXPECT_THROW(sign.signed_distances(points, distances, HUGE_VAL, options), Cancelled);
    EXPECT_THROW(sign.winding_numbers(points, numbers, options), Cancelled);
    EXPECT_THROW(scene.box_overlaps(boxes, options), Cancelled);
    EXPECT_THROW(scene.closest_points(points, {}), InvalidInput);
    EXPECT_THROW(sign.signed_distances(points, {}), InvalidInput);
}

}  // namespace
}  // namespace boxwood
