// SPDX-License-Identifier: Apache-2.0
// A picture has the same bits whatever finds its hits and however many threads render it.
#include <gtest/gtest.h>

#include "boxwood/core/parallel.h"
#include "boxwood/mesh/generate.h"
#include "boxwood/render/render.h"
#include "cases.h"
#include "laws/accelerators.h"
#include "laws/hits.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// Mirrors, glass, shadows, a lens, touching meshes and overlapping spheres.
World small_world() {
    World world;
    world.background = {0.3, 0.4, 0.8};
    world.ambient = {0.2, 0.2, 0.2};
    world.camera.position = {0.1, 0.4, 4};
    world.camera.focal_length = 4;
    world.camera.lens_radius = 0.05;
    world.camera.pixel_spread = 1;
    world.materials = {
        {.ambient = {0.5, 0.2, 0.1},
         .diffuse = {0.6, 0.5, 0.4},
         .specular = {0.3, 0.3, 0.3},
         .mirror = {0.4, 0.4, 0.4},
         .shininess = 32},
        {.ambient = {0.1, 0.1, 0.3},
         .diffuse = {0.1, 0.2, 0.1},
         .specular = {0.5, 0.5, 0.5},
         .refraction = {0.8, 0.9, 0.8},
         .refraction_index = 1.5,
         .shininess = 100},
        {.ambient = {0.3, 0.3, 0.3}, .diffuse = {0.7, 0.7, 0.7}},
    };
    world.lights = {{{3, 4, 5}, {20, 20, 20}}, {{-4, 3, 1}, {10, 5, 5}}};
    world.spheres = {{{1.2, 0.2, 0.5}, 0.5, 1},
                     {{-1.3, 0, 0}, 0.6, 0},
                     {{-1.3, 0.1, 0}, 0.6, 2},
                     {{-1.3, 0, 0}, 0.6, 2}};
    world.add_mesh(generate_torus_knot(1200), 0);
    world.add_mesh(generate_icosphere(320), 1);
    world.add_mesh(moved(generate_terrain(300), 3, {0, 0, -3}), 2);
    world.add_mesh(moved(flat_grid(6), 0.5, {-1.5, -1.5, -1}), 2);
    world.add_mesh(moved(flat_grid(6), 0.5, {-1.5, -1.5, -1}), 0);
    return world;
}

bool are_identical(const ColorImage& a, const ColorImage& b) {
    if (a.width != b.width || a.height != b.height) return false;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            if (!same_bits(a.pixels[i][k], b.pixels[i][k])) return false;
        }
    }
    return true;
}

ColorImage picture(const World& world, const Surfaces& surfaces, IntegratorKind integrator,
                   std::size_t threads) {
    const ThreadLimit limit(threads);
    return render(world, surfaces,
                  {.width = kIsSanitized ? 26 : 50,
                   .height = kIsSanitized ? 20 : 38,
                   .integrator = integrator,
                   .samples = 3,
                   .seed = 5});
}

TEST(ImageLaws, picture_is_the_same_for_every_accelerator_and_any_number_of_threads) {
    const World world = small_world();
    const Surfaces brute(world, {.brute_force = true});
    for (const auto& [integrator_name, integrator] : integrators()) {
        if (integrator == IntegratorKind::heat) continue;  // shows the accelerator itself
        const ColorImage expected = picture(world, brute, integrator, 1);
        for (const auto& [name, options] : all_accelerators()) {
            const Surfaces surfaces(world, options);
            for (const std::size_t threads : {1, 2, 5}) {
                if (options.brute_force && threads == 1) continue;
                EXPECT_TRUE(are_identical(picture(world, surfaces, integrator, threads), expected))
                    << integrator_name << ", " << name << ", " << threads << " threads";
            }
        }
    }
}

TEST(ImageLaws, heat_is_the_same_for_any_number_of_threads) {
    const World world = small_world();
    for (auto [name, options] : all_accelerators()) {
        options.keep_trees = true;
        const Surfaces surfaces(world, options);
        const ColorImage expected = picture(world, surfaces, IntegratorKind::heat, 1);
        for (const std::size_t threads : {2, 5}) {
            EXPECT_TRUE(
                are_identical(picture(world, surfaces, IntegratorKind::heat, threads), expected))
                << name << ", " << threads << " threads";
        }
    }
}

TEST(ImageLaws, seed_chooses_the_samples) {
    const World world = small_world();
    const Surfaces surfaces(world);
    const auto with_seed = [&](std::uint64_t seed) {
        return render(world, surfaces,
                      {.width = 20,
                       .height = 15,
                       .integrator = IntegratorKind::whitted,
                       .samples = 2,
                       .seed = seed});
    };
    EXPECT_TRUE(are_identical(with_seed(3), with_seed(3)));
    EXPECT_FALSE(are_identical(with_seed(3), with_seed(4)));
}

}  // namespace
}  // namespace boxwood
