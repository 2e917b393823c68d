// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/gltf_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "boxwood/image/png.h"
#include "boxwood/world/read_world.h"
#include "error_of.h"
#include "mesh/gltf_json.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

World world_of(const Json& json) {
    const std::string text = json.dump();
    return parse_gltf_world({text, "model.gltf"});
}

TEST(GltfWorld, has_the_files_meshes_materials_camera_and_light) {
    const World world = world_of(square_gltf());
    ASSERT_EQ(world.objects.size(), 1u);
    EXPECT_EQ(world.meshes[world.objects[0].mesh].faces.size(), 2u);
    EXPECT_EQ(world.materials[0].name, "paint");
    EXPECT_EQ(world.materials[0].ambient, Color(0.5, 0.25, 1));
    EXPECT_EQ(world.materials[0].diffuse, Color(0.5, 0.25, 1)) << "no metal";
    EXPECT_TRUE(world.materials[0].is_two_sided);
    EXPECT_FALSE(world.materials[0].culls_back_faces);

    EXPECT_EQ(world.camera.position, Vec3d(0.5, 0.5, 2));
    EXPECT_EQ(world.camera.back, Vec3d::UnitZ());
    EXPECT_EQ(world.camera.field_of_view, 0.9);
    EXPECT_EQ(world.picture.width, 720);
    EXPECT_EQ(world.picture.height, 480);
    EXPECT_EQ(world.picture.encoding, ColorEncoding::srgb);

    ASSERT_EQ(world.lights.size(), 1u);
    EXPECT_EQ(world.lights[0].position, Vec3d(0, 0, 3));
    EXPECT_TRUE(world.lights[0].color.isApprox(Color(10, 5, 2.5) / std::numbers::pi));
    EXPECT_TRUE(world.warnings.is_empty());
}

TEST(GltfWorld, without_camera_or_lights_gets_a_framed_view_and_a_studio) {
    Json json = square_gltf();
    json["nodes"][0].erase("children");
    const World world = world_of(json);
    EXPECT_TRUE(world.cameras.empty());
    EXPECT_GE(world.lights.size(), 2u);
    const Film film = world.camera.film(640, 480);
    for (const Vec3d& p : world.meshes[0].vertices) {
        const Vec3d seen = p - world.camera.position;
        const double depth = -seen.dot(world.camera.back) / world.camera.focal_length;
        EXPECT_GT(depth, 0);
        EXPECT_LT(std::abs(seen.dot(world.camera.right)) / depth, film.half_width);
        EXPECT_LT(std::abs(seen.dot(world.camera.up)) / depth, film.half_height);
    }
}

TEST(GltfWorld, several_nodes_share_a_mesh) {
    Json json = square_gltf();
    json["nodes"][1]["mesh"] = 0;
    const World world = world_of(json);
    EXPECT_EQ(world.meshes.size(), 1u);
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(Vec3d(world.objects[1].to_world.translation()), Vec3d(0.5, 0.5, 2));
}

TEST(GltfWorld, objects_that_are_scaled_to_nothing_are_left_out_with_a_warning) {
    Json json = square_gltf();
    json["nodes"][0]["scale"] = {1, 0, 1};
    const World world = world_of(json);
    EXPECT_TRUE(world.objects.empty());
    EXPECT_EQ(world.warnings.count("objects without an extent, left out"), 1u);
}

TEST(GltfWorld, cameras_to_choose_from) {
    Json json = square_gltf();
    json["cameras"].push_back(
        {{"type", "orthographic"}, {"name", "plan"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}}}});
    json["nodes"][2]["camera"] = 1;
    World world = world_of(json);
    ASSERT_EQ(world.cameras.size(), 2u);
    EXPECT_TRUE(world.camera.is_perspective);
    use_camera(world, 1);
    EXPECT_FALSE(world.camera.is_perspective);
    EXPECT_EQ(world.cameras[1].name, "plan");
    const Film film = world.camera.film(world.picture.width, world.picture.height);
    EXPECT_NEAR(film.half_height, 2, 1e-12);
    EXPECT_NEAR(film.half_width, 3, 1e-12);
}

TEST(GltfWorld, spots_and_directional_lights_point_along_their_nodes) {
    Json json = square_gltf();
    json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
        {{"type", "directional"}, {"intensity", 3}}};
    const double half = std::sqrt(0.5);
    json["nodes"][2]["rotation"] = {-half, 0, 0, half};  // -z turned to -y
    json["nodes"][1]["extensions"] = {{"KHR_lights_punctual", {{"light", 1}}}};
    const World world = world_of(json);
    ASSERT_EQ(world.lights.size(), 2u);
    EXPECT_EQ(world.lights[0].kind, LightKind::directional);
    EXPECT_EQ(world.lights[0].direction, Vec3d(0, 0, -1));
    EXPECT_EQ(world.lights[1].kind, LightKind::spot);
    EXPECT_TRUE(world.lights[1].direction.isApprox(Vec3d(0, -1, 0)));
    EXPECT_EQ(world.lights[1].cos_inner, std::cos(0.2));
    EXPECT_EQ(world.lights[1].cos_outer, std::cos(0.4));
}

TEST(GltfWorld, textures_come_from_files_and_buffers_with_their_transforms) {
    const TempDir dir;
    Rgba8Image image(3, 2, {10, 20, 30, 255});
    write_png(dir / "paint.png", image);
    const std::string png = content_of(dir / "paint.png");
    Json json = square_gltf();
    json["images"] = {{{"uri", "paint.png"}}, {{"bufferView", 5}, {"mimeType", "image/png"}}};
    json["buffers"].push_back({{"byteLength", png.size()}, {"uri", data_uri(png)}});
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", png.size()}});
    json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    json["textures"] = {{{"source", 0}}, {{"source", 1}, {"sampler", 0}}};
    json["materials"][0]["emissiveFactor"] = {1, 0.5, 0};
    json["materials"][0]["emissiveTexture"] = {{"index", 0}};
    json["materials"][0]["extensions"] = {
        {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}};
    json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 1},
        {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {2, 3}}}}}}};
    const World world = read_world(dir.write("model.gltf", json.dump()));
    ASSERT_EQ(world.textures.size(), 2u);
    EXPECT_EQ(world.textures[0].image.pixels, image.pixels);
    EXPECT_EQ(world.textures[1].image.pixels, image.pixels);
    EXPECT_EQ(world.textures[1].wrap_x, TextureWrap::clamp);
    EXPECT_EQ(world.textures[1].wrap_y, TextureWrap::mirror);
    EXPECT_FALSE(world.textures[1].is_smooth);
    const Material& material = world.materials[0];
    EXPECT_EQ(material.emission, Color(4, 2, 0));
    ASSERT_TRUE(material.color_texture && material.emission_texture);
    EXPECT_EQ(material.color_texture->texture, 1u);
    // glTF's (u, v) = (0.5, 0.25) is (0.5, 0.75) here, and goes to (2 u + 0.5, 3 v + 0.25).
    EXPECT_TRUE(material.color_texture->place({0.5, 0.75}).isApprox(Vec2d(1.5, 1)));
}

TEST(GltfWorld, rotated_textures_turn_as_the_extension_says) {
    Json json = square_gltf();
    json["images"] = {{{"uri", "missing.png"}}};
    json["textures"] = {{{"source", 0}}};
    json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 0},
        {"extensions", {{"KHR_texture_transform", {{"rotation", std::numbers::pi / 2}}}}}};
    const World world = world_of(json);
    // Counter-clockwise where v points down: u' = v, v' = -u.
    const Vec2d place = world.materials[0].color_texture->place({0.25, 1 - 0.5});
    EXPECT_TRUE(place.isApprox(Vec2d(0.5, -0.25))) << place.transpose();
    EXPECT_EQ(world.warnings.count("textures that can't be read, shown white"), 1u);
}

TEST(GltfWorld, alpha_modes_become_opacity) {
    Json json = square_gltf();
    json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.3};
    EXPECT_EQ(world_of(json).materials[0].opacity, 1) << "opaque unless it says otherwise";
    json["materials"][0]["alphaMode"] = "BLEND";
    EXPECT_EQ(world_of(json).materials[0].opacity, 0.3);
    EXPECT_TRUE(world_of(json).materials[0].blends);
    json["materials"][0]["alphaMode"] = "MASK";
    EXPECT_EQ(world_of(json).materials[0].opacity_cutoff, 0.5);
    json["materials"][0]["alphaMode"] = "FADE";
    EXPECT_EQ(
        error_of([&] { world_of(json); }),
        "ParseError model.gltf:$.materials[0].alphaMode: found \"FADE\", expected \"OPAQUE\", "
        "\"MASK\" or \"BLEND\"");
}

TEST(GltfWorld, what_is_not_shown_is_told) {
    Json json = square_gltf();
    json["animations"] = {{{"channels", Json::array()}}};
    json["nodes"][0]["skin"] = 0;
    json["materials"][0]["normalTexture"] = {{"index", 0}};
    json["materials"][0]["occlusionTexture"] = {{"index", 0}};
    const World world = world_of(json);
    EXPECT_EQ(world.warnings.count("animations, left out"), 1u);
    EXPECT_EQ(world.warnings.count("skins, left in their own pose"), 1u);
    EXPECT_EQ(world.warnings.count("textures of normals and occlusion, left out"), 2u);
}

TEST(GltfWorld, unlit_materials_shine_by_themselves) {
    Json json = square_gltf();
    json["materials"][0]["extensions"]["KHR_materials_unlit"] = Json::object();
    const Material material = world_of(json).materials[0];
    EXPECT_EQ(material.emission, Color(0.5, 0.25, 1));
    EXPECT_TRUE(material.diffuse.isZero(0) && material.ambient.isZero(0));
}

struct Case {
    const char* place;
    const char* value;
    const char* complaint;
};

TEST(BadGltfWorld, each_fault_is_told_with_its_place) {
    constexpr Case kCases[] = {
        {"/nodes/1/camera", "1", "$.nodes[1].camera: found 1, expected a whole number from 0 to 0"},
        {"/cameras/0/type", "\"fisheye\"",
         "$.cameras[0].type: found \"fisheye\", expected \"perspective\" or \"orthographic\""},
        {"/cameras/0/perspective/yfov", "0",
         "$.cameras[0].perspective.yfov: found 0, expected a number above 0"},
        {"/cameras/0/perspective/yfov", "3.2",
         "$.cameras[0].perspective.yfov: found 3.2, expected an angle below pi"},
        {"/cameras/0/perspective/aspectRatio", "1e9",
         "$.cameras[0].perspective.aspectRatio: found 1000000000.0, expected a number from 0.01 to "
         "100"},
        {"/nodes/2/extensions/KHR_lights_punctual/light", "1",
         "$.nodes[2].extensions.KHR_lights_punctual.light: found 1, expected a whole number from 0 "
         "to 0"},
        {"/extensions", "{}",
         "$.nodes[2].extensions.KHR_lights_punctual.light: found 0, expected nothing, as there is "
         "nothing to choose from"},
        {"/extensions/KHR_lights_punctual/lights/0/type", "\"area\"",
         "$.extensions.KHR_lights_punctual.lights[0].type: found \"area\", expected \"point\", "
         "\"spot\" or \"directional\""},
        {"/extensions/KHR_lights_punctual/lights/0/intensity", "-1",
         "$.extensions.KHR_lights_punctual.lights[0].intensity: found -1, expected a number of at "
         "least 0"},
        {"/materials/0/pbrMetallicRoughness/metallicFactor", "2",
         "$.materials[0].pbrMetallicRoughness.metallicFactor: found 2, expected a number from 0 to "
         "1"},
        {"/materials/0/pbrMetallicRoughness/baseColorFactor", "[1, 1, 1]",
         "$.materials[0].pbrMetallicRoughness.baseColorFactor: found an array of 3, expected an "
         "array of 4 numbers"},
        {"/materials/0/pbrMetallicRoughness/baseColorTexture", "{\"index\": 0}",
         "$.materials[0].pbrMetallicRoughness.baseColorTexture.index: found 0, expected nothing, "
         "as "
         "there is nothing to choose from"},
        {"/materials/0/doubleSided", "\"yes\"",
         "$.materials[0].doubleSided: found \"yes\", expected true or false"},
    };
    for (const Case& c : kCases) {
        Json json = square_gltf();
        json[Json::json_pointer(c.place)] = Json::parse(c.value);
        EXPECT_EQ(error_of([&] { world_of(json); }),
                  "ParseError model.gltf:" + std::string(c.complaint))
            << c.place << " " << c.value;
    }
}

}  // namespace
}  // namespace boxwood
