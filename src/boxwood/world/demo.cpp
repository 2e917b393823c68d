// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/demo.h"

#include <utility>

#include "boxwood/mesh/generate.h"

namespace boxwood {

namespace {

TriangleMesh moved(TriangleMesh mesh, const Vec3d& scale, const Vec3d& shift) {
    for (Vec3d& vertex : mesh.vertices) vertex = scale.cwiseProduct(vertex) + shift;
    return mesh;
}

/// Turns z up into y up without mirroring.
TriangleMesh with_y_up(TriangleMesh mesh) {
    for (Vec3d& vertex : mesh.vertices) vertex = {vertex.x(), vertex.z(), -vertex.y()};
    return mesh;
}

Material matte(const Color& color) {
    return {.ambient = color, .diffuse = color, .specular = Color::Constant(0.05), .shininess = 20};
}

}  // namespace

World make_demo_world(std::size_t triangles) {
    World world;
    world.picture = {
        .width = 960, .height = 540, .integrator = IntegratorKind::whitted, .samples = 16};
    world.background = {0.62, 0.74, 0.88};
    world.ambient = {0.26, 0.29, 0.34};
    world.camera.look_at({0.4, 1.5, 5.6}, {0, 0.62, 0});
    world.camera.field_of_view = 0.62;
    world.camera.focal_length = 5.6;
    world.camera.lens_radius = 0.02;
    world.camera.pixel_spread = 1;

    Material terracotta = matte({0.72, 0.33, 0.20});
    terracotta.specular = Color::Constant(0.35);
    terracotta.shininess = 60;
    Material gold = matte({0.75, 0.55, 0.18});
    gold.specular = {0.5, 0.42, 0.2};
    gold.shininess = 90;
    gold.mirror = {0.18, 0.14, 0.06};
    const Material chrome = {.ambient = Color::Constant(0.05),
                             .diffuse = Color::Constant(0.05),
                             .specular = Color::Constant(0.6),
                             .mirror = Color::Constant(0.8),
                             .shininess = 300};
    const Material glass = {.ambient = Color::Zero(),
                            .diffuse = Color::Constant(0.02),
                            .specular = Color::Constant(0.6),
                            .mirror = Color::Constant(0.1),
                            .refraction = {0.84, 0.9, 0.88},
                            .refraction_index = 1.5,
                            .shininess = 300};
    Material floor = matte({0.55, 0.55, 0.52});
    floor.mirror = Color::Constant(0.06);
    world.materials = {terracotta, gold, chrome, glass, floor, matte({0.34, 0.38, 0.30})};

    world.lights = {{.position = {5, 8, 6}, .color = Color(1.0, 0.95, 0.85) * 85},
                    {.position = {-6, 5, 3}, .color = Color(0.7, 0.8, 1.0) * 22}};

    const Vec3d ones = Vec3d::Ones();
    world.add_mesh(moved(generate_gyroid(triangles / 2), 0.78 * ones, {-1.25, 0.78, 0}), 0);
    world.add_mesh(
        moved(with_y_up(generate_torus_knot(triangles / 4)), 0.85 * ones, {1.3, 0.62, -0.1}), 1);
    world.add_mesh(moved(with_y_up(generate_terrain(triangles / 4)), {14, 3.2, 5}, {0, -0.1, -12}),
                   5);
    world.add_mesh(
        TriangleMesh{.vertices = {{-30, 0, 12}, {30, 0, 12}, {30, 0, -14}, {-30, 0, -14}},
                     .faces = {{0, 1, 2}, {0, 2, 3}}},
        4);
    world.spheres = {{.center = {0.12, 0.42, 0.75}, .radius = 0.42, .material = 3},
                     {.center = {0.1, 0.5, -1.1}, .radius = 0.5, .material = 2}};
    return world;
}

}  // namespace boxwood
