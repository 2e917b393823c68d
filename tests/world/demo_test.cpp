// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/demo.h"

#include <gtest/gtest.h>

#include "boxwood/render/render.h"

namespace boxwood {
namespace {

TEST(Demo, has_about_as_many_triangles_as_asked_for) {
    for (const std::size_t triangles : {10'000, 100'000}) {
        std::size_t found = 0;
        for (const MeshData& mesh : make_demo_world(triangles).meshes) found += mesh.faces.size();
        EXPECT_NEAR(static_cast<double>(found), static_cast<double>(triangles), 0.25 * triangles);
    }
}

TEST(Demo, materials_are_in_range_and_meshes_sound) {
    const World world = make_demo_world(5000);
    EXPECT_FALSE(world.lights.empty());
    for (const MeshData& mesh : world.meshes) {
        EXPECT_NO_THROW(check_indices(mesh));
    }
    for (const Sphere& sphere : world.spheres) EXPECT_LT(sphere.material, world.materials.size());
}

TEST(Demo, picture_is_neither_empty_nor_blown_out) {
    const World world = make_demo_world(5000);
    const Surfaces surfaces(world);
    const RenderOptions options = {
        .width = 96, .height = 54, .integrator = IntegratorKind::whitted};
    const Rgba8Image image = to_rgba8(render(world, surfaces, options));
    int white = 0, background = 0;
    const Rgba8 sky = to_rgba8(world.background);
    for (const Rgba8& pixel : image.pixels) {
        white += pixel == Rgba8{255, 255, 255, 255};
        background += pixel == sky;
    }
    const auto pixels = static_cast<int>(image.pixels.size());
    EXPECT_LT(white, pixels / 20);
    EXPECT_LT(background, pixels * 3 / 4);
}

}  // namespace
}  // namespace boxwood
