// SPDX-License-Identifier: Apache-2.0
#include "boxwood/render/integrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laws/mesh_families.h"

namespace boxwood {
namespace {

const Color kSky(0.1, 0.2, 0.4);

Color radiance(const World& world, IntegratorKind kind, const Ray& ray, int bounces = 5) {
    const Surfaces surfaces(world);
    return make_integrator(kind, world, surfaces, bounces)->radiance(ray);
}

/// A square of side 10 in the plane z = 0, lit from (0, 0, 2), seen from (3, 0, 4) in its middle.
World lit_square() {
    World world;
    world.background = kSky;
    world.ambient = {0.1, 0.2, 0.3};
    world.materials = {{.ambient = {0.5, 0.5, 1},
                        .diffuse = {0.2, 0.4, 0.6},
                        .specular = {0.3, 0.3, 0.3},
                        .shininess = 8}};
    world.lights = {{{0, 0, 2}, {4, 4, 4}}};
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 0}), 0);
    return world;
}
const Ray kAtMiddle = {.origin = {3, 0, 4}, .direction = {-6, 0, -8}};

/// Of the point (0, 0, 0): N.L = 1, d = 2, V = (3, 0, 4) / 5, N.H = cos of half the angle to V.
Color expected_phong() {
    const double specular = std::pow(std::sqrt((1 + 0.8) / 2), 8);
    return Color(0.05, 0.1, 0.3) + Color(0.2, 0.4, 0.6) + Color::Constant(0.3 * specular);
}

TEST(Phong, is_ambient_plus_diffuse_plus_specular_over_squared_distance) {
    const Color found = radiance(lit_square(), IntegratorKind::phong, kAtMiddle);
    EXPECT_TRUE(found.isApprox(expected_phong(), 1e-12)) << found.transpose();
}

TEST(Phong, miss_is_the_background) {
    EXPECT_EQ(radiance(lit_square(), IntegratorKind::phong,
                       {.origin = {0, 0, 1}, .direction = {0, 0, 1}}),
              kSky);
    EXPECT_EQ(radiance(lit_square(), IntegratorKind::whitted,
                       {.origin = {0, 0, 1}, .direction = {0, 0, 1}}),
              kSky);
}

TEST(Phong, light_behind_the_surface_adds_nothing_but_what_the_half_vector_sees) {
    World world = lit_square();
    world.materials[0].specular.setZero();
    world.lights[0].position.z() = -2;
    const Color found = radiance(world, IntegratorKind::phong, kAtMiddle);
    EXPECT_TRUE(found.isApprox(Color(0.05, 0.1, 0.3), 1e-12)) << found.transpose();
}

TEST(Phong, casts_no_shadows) {
    World world = lit_square();
    world.spheres = {{{0, 0, 1}, 0.25, 0}};
    const Color found = radiance(world, IntegratorKind::phong, kAtMiddle);
    EXPECT_TRUE(found.isApprox(expected_phong(), 1e-12)) << found.transpose();
}

TEST(Whitted, is_phong_where_nothing_is_in_the_way) {
    const Color found = radiance(lit_square(), IntegratorKind::whitted, kAtMiddle);
    EXPECT_TRUE(found.isApprox(expected_phong(), 1e-12)) << found.transpose();
}

TEST(Whitted, sphere_between_light_and_surface_casts_a_shadow) {
    World world = lit_square();
    world.spheres = {{{0, 0, 1}, 0.25, 0}};
    const Color found = radiance(world, IntegratorKind::whitted, kAtMiddle);
    EXPECT_TRUE(found.isApprox(Color(0.05, 0.1, 0.3), 1e-12)) << found.transpose();
}

TEST(Whitted, mesh_between_light_and_surface_casts_a_shadow_but_not_one_behind_the_light) {
    World world = lit_square();
    world.add_mesh(moved(flat_grid(1), 1, {-0.5, -0.4, 1}), 0);
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, kAtMiddle).isApprox(Color(0.05, 0.1, 0.3), 1e-12));
    world.meshes[1].vertices = moved(flat_grid(1), 1, {-0.5, -0.4, 2.5}).vertices;
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, kAtMiddle).isApprox(expected_phong(), 1e-12));
}

/// Nothing but a mirror: what it shows is what it reflects.
World mirror_world() {
    World world;
    world.background = kSky;
    world.ambient = Color::Ones();
    world.materials = {{.mirror = {0.5, 0.6, 0.7}}, {.ambient = {0.9, 0.8, 0.1}}};
    return world;
}

TEST(Whitted, flat_mirror_shows_what_is_opposite) {
    World world = mirror_world();
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 0}), 0);
    EXPECT_TRUE(radiance(world, IntegratorKind::whitted, kAtMiddle)
                    .isApprox(kSky.cwiseProduct(Color(0.5, 0.6, 0.7)), 1e-12));
    // The ray comes from x = 3 and is mirrored to x = -3.
    world.spheres = {{{-3, 0, 4}, 0.5, 1}};
    EXPECT_TRUE(radiance(world, IntegratorKind::whitted, kAtMiddle)
                    .isApprox(Color(0.45, 0.48, 0.07), 1e-12));
}

TEST(Whitted, mirroring_sphere_reflects_about_its_normal) {
    World world = mirror_world();
    world.spheres = {{{0, 0, -5}, 1, 0}, {{0, 10, -5 + std::sqrt(0.5)}, 1, 1}};
    // Hits where the normal is (0, 1, 1) / sqrt(2): straight up from there.
    const Ray ray = {.origin = {0, std::sqrt(0.5), 0}};
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, ray).isApprox(Color(0.45, 0.48, 0.07), 1e-9));
}

TEST(Whitted, two_mirrors_bounce_until_the_limit) {
    World world = mirror_world();
    world.materials[0].mirror = Color::Constant(0.5);
    world.materials[0].ambient = Color::Ones();
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 0}), 0);
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 2}), 0);
    const Ray ray = {.origin = {0.2, 0.1, 1}};
    double expected = 0;
    for (int bounces = 0; bounces <= 8; ++bounces) {
        expected += std::pow(0.5, bounces);
        const Color found = radiance(world, IntegratorKind::whitted, ray, bounces);
        EXPECT_NEAR(found.x(), expected, 1e-12) << bounces;
    }
}

World glass_world(double refraction_index) {
    World world = mirror_world();
    world.materials[0] = {.refraction = Color::Ones(), .refraction_index = refraction_index};
    world.spheres = {{{0, 0, -5}, 1, 0}};
    return world;
}

TEST(Whitted, glass_of_index_1_passes_straight) {
    World world = glass_world(1);
    world.spheres.push_back({{0.9, 0, -20}, 0.01, 1});
    const Ray at_small_sphere = {.origin = {0.9, 0, 0}};
    EXPECT_TRUE(radiance(world, IntegratorKind::whitted, at_small_sphere)
                    .isApprox(Color(0.9, 0.8, 0.1), 1e-12));
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, {.origin = {0.8, 0.1, 0}}).isApprox(kSky, 1e-12));
}

TEST(Whitted, glass_bends_by_snells_law) {
    // A ray enters a slab, modelled by one face, at 45 degrees; sin leaves divided by the index.
    World world = glass_world(1.5);
    world.spheres = {};
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 0}), 0);
    const double sine = std::sqrt(0.5) / 1.5;
    const Vec3d bent(sine, 0, -std::sqrt(1 - sine * sine));
    world.spheres = {{100 * bent, 0.01, 1}};
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, {.origin = {-1, 0, 1}, .direction = {1, 0, -1}})
            .isApprox(Color(0.9, 0.8, 0.1), 1e-12));
    // And out of the glass, from below, the other way round.
    const Vec3d out(std::sqrt(0.5), 0, std::sqrt(0.5));
    world.spheres = {{100 * out, 0.01, 1}};
    const Vec3d in(sine, 0, std::sqrt(1 - sine * sine));
    EXPECT_TRUE(radiance(world, IntegratorKind::whitted, {.origin = -in, .direction = in})
                    .isApprox(Color(0.9, 0.8, 0.1), 1e-12));
}

TEST(Whitted, total_internal_reflection_mirrors) {
    World world = glass_world(1.5);
    world.spheres = {{{2, 0, -1}, 0.3, 1}};
    world.add_mesh(moved(flat_grid(1), 10, {-5, -5.1, 0}), 0);
    // From below at a flat angle: back down on the sphere, though it is not a mirror.
    const Ray ray = {.origin = {-2, 0, -1}, .direction = {2, 0, 1}};
    EXPECT_TRUE(
        radiance(world, IntegratorKind::whitted, ray).isApprox(Color(0.9, 0.8, 0.1), 1e-12));
}

TEST(Whitted, grazing_glass_and_strange_indices_give_finite_colors) {
    for (const double index : {1e-3, 0.5, 1.0, 1.5, 1e3}) {
        const World world = glass_world(index);
        for (int i = -100; i <= 100; ++i) {
            const Color found =
                radiance(world, IntegratorKind::whitted, {.origin = {i / 100.0, 0, 0}});
            EXPECT_TRUE(found.allFinite()) << index << " " << i;
        }
    }
}

TEST(Whitted, degenerate_lights_do_not_crash) {
    World world = lit_square();
    world.lights.push_back({{0, 0, 0}, {1, 1, 1}});  // on the surface itself
    radiance(world, IntegratorKind::whitted, kAtMiddle);
    radiance(world, IntegratorKind::phong, kAtMiddle);
}

TEST(Normal, shows_the_normal_from_0_to_1) {
    EXPECT_EQ(radiance(lit_square(), IntegratorKind::normal, kAtMiddle), Color(0.5, 0.5, 1));
    EXPECT_EQ(radiance(lit_square(), IntegratorKind::normal,
                       {.origin = {0, 0, 1}, .direction = {0, 0, 1}}),
              Color(0, 0, 0));
}

TEST(Depth, nearest_is_white_farthest_dark_and_nothing_black) {
    const World world = lit_square();
    const Surfaces surfaces(world);
    const auto depth = make_integrator(IntegratorKind::depth, world, surfaces, 5);
    ColorImage image(4, 1, Color::Zero());
    for (int i = 0; i < 3; ++i) image.at(i, 0) = depth->radiance({.origin = {0.5, 0.5, 2.0 + i}});
    image.at(3, 0) = depth->radiance({.origin = {0, 0, 1}, .direction = {0, 0, 1}});
    depth->develop(image);
    EXPECT_EQ(image.at(0, 0), Color(1, 1, 1));
    EXPECT_NEAR(image.at(1, 0).x(), 0.55, 1e-12);
    EXPECT_NEAR(image.at(2, 0).x(), 0.1, 1e-12);
    EXPECT_EQ(image.at(3, 0), Color(0, 0, 0));
}

TEST(Depth, picture_of_nothing_is_black) {
    const World world;
    const Surfaces surfaces(world);
    const auto depth = make_integrator(IntegratorKind::depth, world, surfaces, 5);
    ColorImage image(2, 2, depth->radiance({}));
    depth->develop(image);
    for (const Color& pixel : image.pixels) EXPECT_EQ(pixel, Color(0, 0, 0));
}

TEST(Heat, shows_more_where_there_is_more_to_do) {
    const World world = lit_square();
    const Surfaces surfaces(world, {.keep_trees = true});
    const auto heat = make_integrator(IntegratorKind::heat, world, surfaces, 5);
    EXPECT_GT(heat->radiance(kAtMiddle).x(), 0);
    EXPECT_GT(heat->radiance(kAtMiddle).x(), heat->radiance({.origin = {100, 0, 1}}).x());
}

TEST(Integrators, what_a_ray_sees_does_not_depend_on_the_rays_beside_it) {
    World world = lit_square();
    world.materials.push_back({.diffuse = {0.5, 0.5, 0.5},
                               .mirror = {0.3, 0.4, 0.5},
                               .refraction = {0.6, 0.5, 0.4},
                               .refraction_index = 1.5});
    world.lights.push_back({{3, 3, 3}, {1, 2, 3}});
    world.spheres = {{{0, 0, 1}, 0.5, 1}, {{1, 1, 0.5}, 0.5, 1}, {{-1, 1, 0.7}, 0.3, 0}};
    const Surfaces surfaces(world, {.keep_trees = true});
    std::vector<Ray> rays;
    for (int i = 0; i < 400; ++i)
        rays.push_back({.origin = {3, 0, 4},
                        .direction = Vec3d(i % 20 - 9.7, i / 20 - 9.7, 0) * 0.5 - Vec3d(3, 0, 4)});
    for (const auto& [name, kind] : integrators()) {
        const auto integrator = make_integrator(kind, world, surfaces, 5);
        const std::vector<Color> together = integrator->radiances(rays);
        ASSERT_EQ(together.size(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_EQ(together[i], integrator->radiance(rays[i])) << name << " " << i;
        EXPECT_TRUE(integrator->radiances({}).empty()) << name;
    }
}

TEST(Integrators, have_names) {
    std::vector<std::string_view> names;
    for (const auto& [name, kind] : integrators()) names.push_back(name);
    EXPECT_EQ(names,
              (std::vector<std::string_view>{"phong", "whitted", "normal", "depth", "heat"}));
}

}  // namespace
}  // namespace boxwood
