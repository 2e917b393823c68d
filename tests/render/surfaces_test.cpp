// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boxwood/mesh/generate.h"
#include "cases.h"
#include "laws/mesh_families.h"
#include "laws/random.h"

namespace boxwood {
namespace {

/// A sphere of radius 1 at z = -5 before a square at z = -8.
World sphere_before_wall() {
    World world;
    world.materials.resize(2);
    world.spheres = {{{0, 0, -5}, 1, 0}};
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5, -8}), 1);
    return world;
}

TEST(Surfaces, sphere_hit_has_outward_normal_and_material) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    const auto hit = surfaces.closest_hit({});
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 4);
    EXPECT_TRUE(hit->point.isApprox(Vec3d(0, 0, -4)));
    EXPECT_TRUE(hit->normal.isApprox(Vec3d(0, 0, 1)));
    EXPECT_EQ(hit->material, &world.materials[0]);
    EXPECT_EQ(hit->id, (TriangleId{1, 0}));

    const auto from_inside = surfaces.closest_hit({.origin = {0, 0, -5}, .direction = {0, 1, 0}});
    ASSERT_TRUE(from_inside);
    EXPECT_TRUE(from_inside->normal.isApprox(Vec3d(0, 1, 0))) << "outward from inside, too";
}

TEST(Surfaces, mesh_hit_has_geometric_normal_and_material) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    const auto hit = surfaces.closest_hit({.origin = {2, 2.5, 0}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 8);
    EXPECT_EQ(hit->normal, Vec3d(0, 0, 1));
    EXPECT_EQ(hit->material, &world.materials[1]);
    EXPECT_EQ(hit->id.instance, 0u);
}

TEST(Surfaces, ray_that_goes_on_from_a_sphere_sees_its_far_side) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    const auto near = surfaces.closest_hit({});
    const Ray inwards = {.origin = near->point, .skip = near->id};
    const auto far = surfaces.closest_hit(inwards);
    ASSERT_TRUE(far);
    EXPECT_DOUBLE_EQ(far->t, 2);
    const auto wall = surfaces.closest_hit({.origin = far->point, .skip = far->id});
    ASSERT_TRUE(wall);
    EXPECT_EQ(wall->id.instance, 0u);
    EXPECT_FALSE(
        surfaces.any_hit({.origin = near->point, .direction = {0, 0, 1}, .skip = near->id}));
}

/// Where points are rounded to the wrong side of their plane, neighbours in it must not catch rays.
TEST(Surfaces, rays_that_go_on_from_a_tilted_plane_do_not_hit_it_again) {
    Random random(4);
    for (int i = 0; i < cases(200); ++i) {
        World world;
        world.materials.resize(1);
        const Vec3d n = random.direction(), u = n.cross(random.direction()).normalized();
        const Vec3d v = n.cross(u), center = random.point(-100, 100);
        TriangleMesh mesh = flat_grid(8);
        for (Vec3d& p : mesh.vertices) p = center + (p.x() - 4) * u + (p.y() - 4) * v;
        world.add_mesh(mesh, 0);
        const Surfaces surfaces(world);
        for (int k = 0; k < 50; ++k) {
            const Vec3d origin = center + 20 * random.direction();
            const Vec3d target = center + random.number(-4, 4) * u + random.number(-4, 4) * v;
            const auto hit = surfaces.closest_hit({.origin = origin, .direction = target - origin});
            if (!hit) continue;
            EXPECT_FALSE(surfaces.any_hit(hit->ray_towards(random.direction()))) << i << " " << k;
        }
    }
}

TEST(Surfaces, any_hit_sees_spheres_and_meshes_up_to_t_max) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    EXPECT_TRUE(surfaces.any_hit({}));
    EXPECT_FALSE(surfaces.any_hit({.t_max = 3.9}));
    EXPECT_TRUE(surfaces.any_hit({.origin = {2, 2.5, 0}}));
    EXPECT_FALSE(surfaces.any_hit({.origin = {2, 2.5, 0}, .t_max = 7.9}));
    EXPECT_FALSE(surfaces.any_hit({.direction = {0, 0, 1}}));
}

TEST(Surfaces, many_spheres_are_found_as_if_each_were_tried) {
    constexpr std::uint64_t kSeed = 3;
    Random random(kSeed);
    World world;
    world.materials.resize(1);
    for (int i = 0; i < 200; ++i)
        world.spheres.push_back({random.point(-5, 5), random.number(0.1, 1), 0});
    world.spheres.push_back(world.spheres[7]);  // a tie
    const Surfaces surfaces(world);
    for (int i = 0; i < cases(3000); ++i) {
        const Ray ray = {.origin = random.point(-8, 8), .direction = random.direction()};
        std::optional<std::uint32_t> expected;
        double least = ray.t_max;
        for (std::uint32_t k = 0; k < world.spheres.size(); ++k) {
            World one;
            one.materials.resize(1);
            one.spheres = {world.spheres[k]};
            const auto hit = Surfaces(one).closest_hit(ray);
            if (!hit || !(hit->t < least)) continue;
            least = hit->t;
            expected = k;
        }
        const auto found = surfaces.closest_hit(ray);
        ASSERT_EQ(found.has_value(), expected.has_value()) << "seed " << kSeed << ", ray " << i;
        ASSERT_EQ(surfaces.any_hit(ray), expected.has_value()) << i;
        if (!found) continue;
        ASSERT_EQ(found->id.triangle, *expected) << "seed " << kSeed << ", ray " << i;
        ASSERT_EQ(found->t, least);
    }
}

TEST(Surfaces, batches_find_sphere_wall_and_nothing_in_order) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    Random random(5);
    std::vector<Ray> rays;
    for (int i = 0; i < 1000; ++i)
        rays.push_back({.origin = {random.number(-6, 6), random.number(-6, 6), 0}});
    for (int i = 0; i < 100; ++i)
        rays.push_back({.origin = {random.number(-1, 1), random.number(-1, 1), 0}});
    const SurfaceHits hits = surfaces.closest_hits(rays);
    const std::vector<bool> any = surfaces.any_hits(rays);
    ASSERT_EQ(hits.size(), rays.size());
    ASSERT_EQ(any.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double x = rays[i].origin.x(), y = rays[i].origin.y();
        const double below_top = 1 - x * x - y * y;
        const bool on_wall = std::abs(x) <= 5 && std::abs(y) <= 5;
        ASSERT_EQ(hits[i].has_value(), below_top > 0 || on_wall) << i;
        ASSERT_EQ(any[i], hits[i].has_value()) << i;
        if (hits[i]) ASSERT_NEAR(hits[i]->t, below_top > 0 ? 5 - std::sqrt(below_top) : 8, 1e-9);
    }
    EXPECT_TRUE(surfaces.closest_hits({}).empty());
    EXPECT_TRUE(surfaces.any_hits({}).empty());
}

TEST(Surfaces, empty_world_is_never_hit) {
    const World world;
    const Surfaces surfaces(world);
    EXPECT_FALSE(surfaces.closest_hit({}));
    EXPECT_FALSE(surfaces.any_hit({}));
}

TEST(Surfaces, rays_that_are_none_hit_nothing) {
    const World world = sphere_before_wall();
    const Surfaces surfaces(world);
    EXPECT_FALSE(surfaces.closest_hit({.direction = {0, 0, 0}}));
    EXPECT_FALSE(surfaces.any_hit({.origin = {0, std::nan(""), 0}}));
}

}  // namespace
}  // namespace boxwood
