// SPDX-License-Identifier: Apache-2.0
// What a place looks like: smooth normals, textures, colors, sides and what is seen through.
#include "boxwood/render/surface_finish.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boxwood/mesh/generate.h"
#include "boxwood/render/integrator.h"
#include "boxwood/render/render.h"
#include "laws/mesh_families.h"

namespace boxwood {
namespace {

/// The triangle (0, 0), (1, 0), (0, 1) at z = 0, seen from z = 1.
MeshData triangle(double z = 0) {
    return {TriangleMesh{{{0, 0, z}, {1, 0, z}, {0, 1, z}}, {{0, 1, 2}}}, {}, {}};
}
Ray down_at(double x, double y) { return {.origin = {x, y, 1}, .direction = {0, 0, -1}}; }
Ray up_at(double x, double y) { return {.origin = {x, y, -1}, .direction = {0, 0, 1}}; }

World world_of(MeshData mesh) {
    World world;
    world.materials.resize(1);
    world.materials[0].ambient = Color::Ones();
    world.ambient = Color::Ones();
    world.add_mesh(std::move(mesh), 0);
    return world;
}

SurfaceHit hit_of(const World& world, const Ray& ray) {
    return Surfaces(world).closest_hit(ray).value();
}

Color color_seen(const World& world, const Ray& ray, IntegratorKind kind = IntegratorKind::phong) {
    const Surfaces surfaces(world);
    return make_integrator(kind, world, surfaces, 5)->radiance(ray);
}

TEST(SurfaceFinish, is_plain_where_the_mesh_says_no_more) {
    const SurfaceHit hit = hit_of(world_of(triangle()), down_at(0.2, 0.3));
    EXPECT_EQ(hit.normal, Vec3d(0, 0, 1));
    EXPECT_EQ(hit.shading_normal, hit.normal);
    EXPECT_EQ(hit.color, Color::Ones());
    EXPECT_EQ(hit.emission, Color::Zero());
    EXPECT_EQ(hit.opacity, 1);
}

TEST(SurfaceFinish, normals_colors_and_textures_are_between_those_of_the_corners) {
    MeshData mesh = triangle();
    mesh.attributes.normals.values = {{0, 0, 1}, {1, 0, 0}, {0, 0, 1}};
    mesh.attributes.colors.values = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    mesh.attributes.texture_coordinates.values = {{0, 0}, {1, 0}, {0, 1}};
    World world = world_of(mesh);
    Texture texture;
    texture.image = Rgba8Image(2, 1, {});
    texture.image.pixels = {{255, 255, 255, 255}, {0, 0, 0, 255}};
    texture.wrap_x = TextureWrap::clamp;
    world.textures = {texture};
    world.materials[0].color_texture = TextureUse{};

    const SurfaceHit hit = hit_of(world, down_at(0.5, 0.25));
    EXPECT_TRUE(hit.shading_normal.isApprox(Vec3d(1, 0, 1).normalized(), 1e-12));
    EXPECT_EQ(hit.normal, Vec3d(0, 0, 1));
    EXPECT_TRUE(hit.color.isApprox(0.5 * Color(0.25, 0.5, 0.25), 1e-12)) << hit.color.transpose();
    world.materials[0].uses_vertex_colors = false;
    EXPECT_TRUE(hit_of(world, down_at(0.5, 0.25)).color.isApprox(Color::Constant(0.5), 1e-12));
}

TEST(SurfaceFinish, values_may_belong_to_corners_or_faces) {
    MeshData mesh = triangle();
    mesh.attributes.colors = {ValuesOf::faces, {{0.5, 0.25, 0, 1}}};
    mesh.attributes.normals = {ValuesOf::corners, {{0, 0, 1}, {0, 1, 0}, {0, 1, 0}}};
    const SurfaceHit hit = hit_of(world_of(mesh), down_at(0.25, 0.25));
    EXPECT_EQ(hit.color, Color(0.5, 0.25, 0));
    EXPECT_TRUE(hit.shading_normal.isApprox(Vec3d(0, 1, 1).normalized(), 1e-12));
}

TEST(SurfaceFinish, normals_turn_and_stretch_with_their_object) {
    // A ball that is squeezed in x: its normals are those of the ellipsoid.
    MeshData ball{generate_icosphere(20'000), {}, {}};
    for (const Vec3d& p : ball.vertices) ball.attributes.normals.values.push_back(p.cast<float>());
    for (const double squeeze : {0.5, -0.5}) {
        World world = world_of(ball);
        world.objects[0].to_world.linear() = Vec3d(squeeze, 1, 1).asDiagonal();
        const Ray ray = {.origin = {0.3, 0.2, 5}, .direction = {0, 0, -1}};
        const SurfaceHit hit = hit_of(world, ray);
        const Vec3d expected(hit.point.x() / 0.25, hit.point.y(), hit.point.z());
        EXPECT_TRUE(hit.shading_normal.isApprox(expected.normalized(), 1e-3)) << squeeze;
        EXPECT_TRUE(hit.normal.isApprox(expected.normalized(), 0.05)) << squeeze;
    }
}

TEST(SurfaceFinish, materials_go_by_the_labels_of_faces) {
    MeshData mesh = triangle();
    mesh.vertices.insert(mesh.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
    mesh.faces.emplace_back(3, 4, 5);
    mesh.attributes.materials = {{"a", "b"}, {1, 0}};
    World world = world_of(mesh);
    world.materials.resize(3);
    world.objects[0].materials = {2, 1};
    EXPECT_EQ(hit_of(world, down_at(0.2, 0.2)).material, &world.materials[1]);
    EXPECT_EQ(hit_of(world, down_at(2.2, 0.2)).material, &world.materials[2]);
}

TEST(SurfaceFinish, two_sided_materials_are_lit_from_behind_as_well) {
    World world = world_of(triangle());
    world.materials[0].ambient.setZero();
    world.materials[0].diffuse = Color::Ones();
    world.lights = {{.position = {0.2, 0.2, -2}, .color = Color::Constant(4)}};
    EXPECT_EQ(color_seen(world, up_at(0.2, 0.2)), Color::Zero());
    world.materials[0].is_two_sided = true;
    EXPECT_TRUE(color_seen(world, up_at(0.2, 0.2)).isApprox(Color::Ones(), 1e-12));
}

TEST(SeeThrough, culled_backs_are_not_seen_but_what_lies_behind_them_is) {
    World world = world_of(triangle());
    world.add_mesh(triangle(0.5), 0);
    world.materials.resize(2);
    world.materials[1].culls_back_faces = true;
    world.objects[0].materials = {1};
    EXPECT_EQ(hit_of(world, up_at(0.2, 0.2)).id.instance, 1u);
    world.objects[1].materials = {1};
    EXPECT_FALSE(Surfaces(world).closest_hit(up_at(0.2, 0.2)));
    EXPECT_TRUE(Surfaces(world).closest_hit(down_at(0.2, 0.2)));
}

TEST(SeeThrough, of_two_opposite_faces_in_one_place_the_front_is_seen) {
    MeshData sheet = triangle();
    sheet.faces.emplace_back(0, 2, 1);
    World world = world_of(sheet);
    world.materials[0].culls_back_faces = true;
    const Surfaces surfaces(world);
    EXPECT_EQ(surfaces.closest_hit(down_at(0.2, 0.2))->id.triangle, 0u);
    EXPECT_EQ(surfaces.closest_hit(up_at(0.2, 0.2))->id.triangle, 1u);
}

TEST(SeeThrough, many_culled_faces_in_one_place_end_the_search) {
    MeshData pile = triangle();
    for (int i = 0; i < 5; ++i) pile.faces.emplace_back(0, 1, 2);
    World world = world_of(pile);
    world.materials[0].culls_back_faces = true;
    EXPECT_FALSE(Surfaces(world).closest_hit(up_at(0.2, 0.2)));
}

World cut_out() {
    MeshData mesh = triangle();
    mesh.attributes.colors.values = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 0}};
    World world = world_of(mesh);
    world.materials[0].opacity_cutoff = 0.5;
    world.background = Color(0, 0, 1);
    return world;
}

TEST(SeeThrough, places_below_the_cutoff_are_not_there) {
    const World world = cut_out();
    EXPECT_EQ(color_seen(world, down_at(0.7, 0.1)), Color::Ones());
    EXPECT_EQ(color_seen(world, down_at(0.2, 0.1)), Color(0, 0, 1));
    const Surfaces surfaces(world);
    EXPECT_TRUE(surfaces.any_hit(down_at(0.7, 0.1)));
    EXPECT_FALSE(surfaces.any_hit(down_at(0.2, 0.1))) << "and cast no shadow";
    const Ray rays[] = {down_at(0.2, 0.1), down_at(0.7, 0.1)};
    EXPECT_EQ(surfaces.any_hits(rays), (std::vector<bool>{false, true}));
}

TEST(SeeThrough, opacity_mixes_with_what_is_behind) {
    World world = world_of(triangle());
    world.materials[0].ambient = Color(1, 0, 0);
    world.materials[0].opacity = 0.25;
    world.background = Color(0, 0, 1);
    for (const auto kind : {IntegratorKind::phong, IntegratorKind::whitted})
        EXPECT_TRUE(color_seen(world, down_at(0.2, 0.2), kind).isApprox(Color(0.25, 0, 0.75)));
    // Two layers, one behind another.
    world.add_mesh(triangle(-1), 0);
    const Color two(0.25 + 0.75 * 0.25, 0, 0.75 * 0.75);
    for (const auto kind : {IntegratorKind::phong, IntegratorKind::whitted})
        EXPECT_TRUE(color_seen(world, down_at(0.2, 0.2), kind).isApprox(two, 1e-9));
}

TEST(SeeThrough, only_materials_that_blend_ask_their_colors) {
    MeshData mesh = triangle();
    mesh.attributes.colors.values.assign(3, VertexColor(1, 1, 1, 0.5f));
    World world = world_of(mesh);
    EXPECT_EQ(hit_of(world, down_at(0.2, 0.2)).opacity, 1);
    world.materials[0].blends = true;
    EXPECT_EQ(hit_of(world, down_at(0.2, 0.2)).opacity, 0.5);
}

TEST(Lights, directional_light_does_not_fade_and_throws_shadows) {
    World world = world_of(triangle());
    world.materials[0].ambient.setZero();
    world.materials[0].diffuse = Color::Ones();
    Light sun;
    sun.kind = LightKind::directional;
    sun.direction = Vec3d(0, -0.6, -0.8);
    sun.color = Color(1, 0.5, 0.25);
    world.lights = {sun};
    for (const auto kind : {IntegratorKind::phong, IntegratorKind::whitted})
        EXPECT_TRUE(color_seen(world, down_at(0.2, 0.2), kind).isApprox(0.8 * sun.color));
    MeshData roof{moved(flat_grid(1), 40, {-20, -20, 7}), {}, {}};
    world.add_mesh(roof, 0);
    EXPECT_EQ(color_seen(world, {.origin = {0.2, 0.2, 1}, .direction = {0, 0, -1}},
                         IntegratorKind::whitted),
              Color::Zero());
}

TEST(Lights, a_spot_is_whole_inside_fades_and_ends) {
    Light spot;
    spot.kind = LightKind::spot;
    spot.position = {0, 0, 2};
    spot.color = Color::Ones();
    spot.cos_inner = std::cos(0.2);
    spot.cos_outer = std::cos(0.6);
    const auto arriving = [&](double angle) {
        const Vec3d point(2 * std::tan(angle), 0, 0);
        return (point - spot.position).squaredNorm() / light_at(spot, point).fall_off;
    };
    EXPECT_NEAR(arriving(0), 1, 1e-12);
    EXPECT_NEAR(arriving(0.19), 1, 1e-12);
    EXPECT_EQ(arriving(0.61), 0);
    EXPECT_GT(arriving(0.3), arriving(0.5));
    const double middle = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
    EXPECT_NEAR(arriving(0.4), middle * middle, 1e-12);
}

TEST(Encoding, is_that_of_the_world_and_only_for_light) {
    World world = world_of(triangle());
    world.materials[0].ambient = Color::Constant(0.18);
    world.picture.encoding = ColorEncoding::srgb;
    world.camera.look_at({0.25, 0.25, 1}, {0.25, 0.25, 0});
    const Surfaces surfaces(world);
    const auto pixel = [&](IntegratorKind kind) {
        return render(world, surfaces, {.width = 1, .height = 1, .integrator = kind}).at(0, 0).z();
    };
    EXPECT_NEAR(pixel(IntegratorKind::phong), 0.4614, 1e-4);
    EXPECT_EQ(pixel(IntegratorKind::normal), 1);
    world.picture.encoding = ColorEncoding::linear;
    EXPECT_EQ(pixel(IntegratorKind::phong), 0.18);
}

}  // namespace
}  // namespace boxwood
