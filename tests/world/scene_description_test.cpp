// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/scene_description.h"

#include <gtest/gtest.h>

#include <numbers>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/world/classic_scene.h"
#include "boxwood/world/degrees.h"
#include "boxwood/world/read_world.h"
#include "error_of.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

class SceneDescription : public testing::Test {
protected:
    World read(const std::string& members) {
        return read_world(dir_.write("scene.json", "{\"boxwood\": 2" + members + "}"));
    }
    /// What is wrong, as "path: message".
    std::string complaint(const std::string& members) {
        std::string text = error_of([&] { read(members); });
        const std::string start = "ParseError " + (dir_ / "scene.json").string() + ":";
        return text.starts_with(start) ? text.substr(start.size()) : text;
    }

    TempDir dir_;
};

TEST_F(SceneDescription, an_empty_scene_is_framed_lit_and_empty) {
    const World world = read("");
    EXPECT_TRUE(world.objects.empty() && world.spheres.empty());
    EXPECT_EQ(world.picture.width, 640);
    EXPECT_EQ(world.picture.integrator, IntegratorKind::whitted);
    EXPECT_EQ(world.picture.encoding, ColorEncoding::srgb);
    EXPECT_FALSE(world.lights.empty());
}

TEST_F(SceneDescription, settings_arrive) {
    const World world = read(R"(,
        "film": {"width": 320, "height": 200, "encoding": "linear"},
        "integrator": {"type": "phong", "bounces": 9}, "sampler": {"samples": 7, "seed": 5},
        "background": [1, 2, 3], "ambient": [4, 5, 6], "lights": [])");
    EXPECT_EQ(world.picture.width, 320);
    EXPECT_EQ(world.picture.height, 200);
    EXPECT_EQ(world.picture.encoding, ColorEncoding::linear);
    EXPECT_EQ(world.picture.integrator, IntegratorKind::phong);
    EXPECT_EQ(world.picture.bounces, 9);
    EXPECT_EQ(world.picture.samples, 7);
    EXPECT_EQ(world.picture.seed, 5u);
    EXPECT_EQ(world.background, Color(1, 2, 3));
    EXPECT_EQ(world.ambient, Color(4, 5, 6));
    EXPECT_TRUE(world.lights.empty());
}

TEST_F(SceneDescription, cameras_look_where_they_should) {
    const World world = read(R"(, "camera": {"from": [1, 2, 3], "to": [1, 2, -7], "up": [1, 0, 0],
        "field_of_view": 90, "focus_distance": 4, "lens_radius": 0.5})");
    EXPECT_EQ(world.camera.position, Vec3d(1, 2, 3));
    EXPECT_EQ(world.camera.back, Vec3d::UnitZ());
    EXPECT_EQ(world.camera.up, Vec3d::UnitX());
    EXPECT_EQ(world.camera.field_of_view, std::numbers::pi / 2);
    EXPECT_EQ(world.camera.focal_length, 4);
    EXPECT_EQ(world.camera.lens_radius, 0.5);

    const World flat = read(R"(, "camera": {"type": "orthographic", "from": [0, 0, 5],
        "direction": [0, 0, -3], "height": 8})");
    EXPECT_FALSE(flat.camera.is_perspective);
    EXPECT_NEAR(flat.camera.film(100, 100).half_height, 4, 1e-12);
}

TEST_F(SceneDescription, meshes_come_from_files_shapes_parallelograms_and_numbers) {
    write_mesh(dir_ / "ball.off", generate_icosphere(80));
    const World world = read(R"(, "meshes": {
        "a file": {"file": "ball.off"}, "b shape": {"shape": "torus_knot", "triangles": 500},
        "c flat": {"parallelogram": {"origin": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0]}},
        "d own": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 2, 0]], "faces": [[2, 1, 0]]}},
        "objects": [{"mesh": "d own"}, {"mesh": "a file"}])");
    ASSERT_EQ(world.meshes.size(), 4u);
    EXPECT_EQ(world.meshes[0].faces.size(), 80u);
    EXPECT_EQ(world.meshes[1].faces, generate_torus_knot(500).faces);
    EXPECT_EQ(world.meshes[2].faces.size(), 2u);
    EXPECT_EQ(world.meshes[3].faces[0], Vec3i(2, 1, 0));
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(world.objects[0].mesh, 3u);
    EXPECT_EQ(world.materials[world.objects[0].materials[0]].name, "clay");
}

TEST_F(SceneDescription, meshes_are_repaired_as_they_say_and_then_as_the_reader_is_told) {
    write_mesh(dir_ / "ball.stl", generate_icosphere(80));
    const auto path = dir_.write("scene.json", R"({"boxwood": 2, "meshes": {
        "a": {"file": "ball.stl", "repair": ["weld"]}, "b": {"file": "ball.stl"},
        "c": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 2, 0]], "faces": [[2, 1, 0], [0, 0, 1]],
              "repair": ["drop-degenerate", "orient"]}}})");
    const World world = read_world(path);
    EXPECT_EQ(world.meshes[0].vertices.size(), 42u);
    EXPECT_EQ(world.meshes[1].vertices.size(), 240u);
    EXPECT_EQ(world.meshes[2].faces.size(), 1u);
    const World welded = read_world(path, {.repair = {RepairStep::weld}});
    EXPECT_EQ(welded.meshes[0].vertices.size(), 42u);
    EXPECT_EQ(welded.meshes[1].vertices.size(), 42u);
    EXPECT_EQ(read_world(dir_ / "ball.stl", {.repair = {RepairStep::weld}}).meshes[0].vertices,
              welded.meshes[1].vertices);
}

TEST_F(SceneDescription, transforms_are_done_one_after_another) {
    const World world = read(R"(, "meshes": {"m": {"shape": "icosphere", "triangles": 20}},
        "objects": [{"mesh": "m", "transform": [
            {"scale": [2, 1, 1]}, {"rotate": {"axis": [0, 0, 5], "angle": 90}},
            {"translate": [10, 0, 0]},
            {"matrix": [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 7, 0, 0, 0, 1]}]}])");
    // (1, 0, 0) -> (2, 0, 0) -> (0, 2, 0) -> (10, 2, 0) -> (2, 10, 7)
    EXPECT_TRUE((world.objects[0].to_world * Vec3d(1, 0, 0)).isApprox(Vec3d(2, 10, 7), 1e-12));
}

TEST_F(SceneDescription, included_files_bring_materials_and_more_from_their_folders) {
    std::filesystem::create_directory(dir_ / "lib");
    write_mesh(dir_ / "lib/ball.off", generate_icosphere(20));
    dir_.write("lib/things.json", R"({"boxwood": 2, "include": ["../more.json"],
        "materials": {"gold": {"diffuse": [1, 0.8, 0]}}, "meshes": {"ball": {"file": "ball.off"}},
        "objects": [{"mesh": "ball", "material": "gold"}]})");
    dir_.write("more.json", R"({"boxwood": 2, "materials": {"blue": {"diffuse": [0, 0, 1]}}})");
    const World world = read(R"(, "include": ["lib/things.json", "more.json"],
        "objects": [{"mesh": "ball", "material": "blue"}])");
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(world.materials[world.objects[0].materials[0]].name, "gold");
    EXPECT_EQ(world.materials[world.objects[1].materials[0]].diffuse, Color(0, 0, 1));
    EXPECT_EQ(world.materials.size(), 2u) << "a file that two others include is read once";
}

TEST_F(SceneDescription, files_that_include_themselves_are_an_error) {
    dir_.write("a.json", R"({"boxwood": 2, "include": ["b.json"]})");
    dir_.write("b.json", R"({"boxwood": 2, "include": ["a.json"]})");
    EXPECT_EQ(error_of([&] { read(R"(, "include": ["a.json"])"); }),
              "ParseError " + (dir_ / "b.json").string() +
                  ":$.include[0]: found \"a.json\", expected a file that doesn't include itself");
    EXPECT_EQ(complaint(R"(, "include": ["scene.json"])"),
              "$.include[0]: found \"scene.json\", expected a file that doesn't include itself");
}

TEST_F(SceneDescription, deep_includes_are_an_error) {
    for (int i = 0; i < 300; ++i)
        dir_.write("f" + std::to_string(i) + ".json",
                   R"({"boxwood": 2, "include": ["f)" + std::to_string(i + 1) + ".json\"]}");
    EXPECT_NE(error_of([&] {
                  read(R"(, "include": ["f0.json"])");
              }).find("expected at most 256 files in one another"),
              std::string::npos);
}

struct Case {
    const char* members;
    const char* complaint;
};

TEST_F(SceneDescription, each_fault_is_told_with_its_place) {
    constexpr Case kCases[] = {
        {R"(, "Camera": {})",
         "$: found unknown key \"Camera\", expected boxwood, include, film, integrator, sampler, "
         "background, ambient, camera, materials, meshes, objects, lights"},
        {R"(, "film": {"width": 0})",
         "$.film.width: found 0, expected a whole number from 1 to 268435456"},
        {R"(, "film": {"width": 100000, "height": 100000})",
         "$.film: found an object, expected a picture of at most 2^28 pixels"},
        {R"(, "film": {"encoding": "hdr"})",
         "$.film.encoding: found \"hdr\", expected one of linear, srgb"},
        {R"(, "integrator": {"type": "path"})",
         "$.integrator.type: found \"path\", expected one of phong, whitted, normal, depth, heat"},
        {R"(, "sampler": {"samples": 0})",
         "$.sampler.samples: found 0, expected a whole number from 1 to 65536"},
        {R"(, "camera": {"from": [0, 0, 1]})",
         "$.camera: found an object, expected either \"to\" or \"direction\""},
        {R"(, "camera": {"from": [0, 0, 1], "to": [0, 0, 1]})",
         "$.camera.to: found an array of 3, expected another place than \"from\""},
        {R"(, "camera": {"from": [0, 0, 1], "direction": [0, 0, 0]})",
         "$.camera.direction: found an array of 3, expected a direction that isn't zero"},
        {R"(, "camera": {"from": [0, 5, 0], "to": [0, 0, 0]})",
         "$.camera: found an object, expected \"up\", as the camera looks along the y axis"},
        {R"(, "camera": {"from": [0, 5, 0], "to": [0, 0, 0], "up": [0, 1, 0]})",
         "$.camera.up: found an array of 3, expected a direction across the one that the camera "
         "looks in"},
        {R"(, "camera": {"from": [0, 5, 0], "to": [0, 0, 0], "field_of_view": 180})",
         "$.camera: found an object, expected \"up\", as the camera looks along the y axis"},
        {R"(, "camera": {"from": [0, 0, 5], "to": [0, 0, 0], "field_of_view": 180})",
         "$.camera.field_of_view: found 180, expected an angle below 180 degrees"},
        {R"(, "camera": {"type": "spherical", "from": [0, 0, 5], "to": [0, 0, 0]})",
         "$.camera.type: found \"spherical\", expected \"perspective\" or \"orthographic\""},
        {R"(, "materials": {"m": {"type": "metallic_roughness"}})",
         "$.materials.m.type: found \"metallic_roughness\", expected \"phong\", the one type that "
         "is "
         "rendered"},
        {R"(, "materials": {"m": {"diffuse": 1}})",
         "$.materials.m.diffuse: found 1, expected an array of 3 numbers"},
        {R"(, "materials": {"m": {"color_texture": "missing.png"}})",
         "$.materials.m.color_texture: found \"missing.png\", expected a file beside the scene"},
        {R"(, "materials": {"m": {"color_texture": {"file": "a.png", "wrap": "tile"}}})",
         "$.materials.m.color_texture.wrap: found \"tile\", expected one of repeat, mirror, clamp"},
        {R"(, "meshes": {"m": {"file": "../m.off"}})",
         "$.meshes.m.file: found \"../m.off\", expected a file in the folder of the file that "
         "names "
         "it or below"},
        {R"(, "meshes": {"m": {"file": "https://x.org/m.off"}})",
         "$.meshes.m.file: found \"https://x.org/m.off\", expected the name of a file here, as "
         "nothing is fetched"},
        {R"(, "meshes": {"m": {"shape": "cow", "triangles": 10}})",
         "$.meshes.m.shape: found \"cow\", expected one of icosphere, torus_knot, gyroid, terrain, "
         "soup, stadium, interior"},
        {R"(, "meshes": {"m": {"shape": "gyroid", "triangles": 0}})",
         "$.meshes.m.triangles: found 0, expected a whole number from 1 to 1000000000"},
        {R"(, "meshes": {"m": {"vertices": [[0, 0, 0]], "faces": [[0, 0, 1]]}})",
         "$.meshes.m.faces[0][2]: found 1, expected a whole number from 0 to 0"},
        {R"(, "meshes": {"m": {"vertices": [[0, 0, 0]], "faces": [[0, 0]]}})",
         "$.meshes.m.faces[0]: found an array of 2, expected an array of 3 indices of vertices"},
        {R"(, "meshes": {"m": {"shape": "gyroid", "triangles": 9, "repair": ["weld", "polish"]}})",
         "$.meshes.m.repair[1]: found \"polish\", expected one of weld, drop-degenerate, orient"},
        {R"(, "meshes": {"m": {"shape": "gyroid", "triangles": 9, "repair": "weld"}})",
         "$.meshes.m.repair: found \"weld\", expected an array"},
        {R"(, "objects": [{"mesh": "m"}])",
         "$.objects[0].mesh: found \"m\", expected the name of a mesh"},
        {R"(, "materials": {"a": {}, "b": {}}, "objects": [{"sphere": {"center": [0, 0, 0],
            "radius": 1}, "material": "c"}])",
         "$.objects[0].material: found \"c\", expected the name of a material: a, b"},
        {R"(, "objects": [{"sphere": {"center": [0, 0, 0], "radius": 0}}])",
         "$.objects[0].sphere.radius: found 0, expected a number above 0"},
        {R"(, "meshes": {"m": {"shape": "gyroid", "triangles": 50}},
            "objects": [{"mesh": "m", "transform": {"scale": 0}}])",
         "$.objects[0].transform: found an object, expected a transform that can be undone"},
        {R"(, "meshes": {"m": {"shape": "gyroid", "triangles": 50}},
            "objects": [{"mesh": "m", "transform": {"scale": 1, "translate": [0, 0, 0]}}])",
         "$.objects[0].transform: found an object, expected one of \"translate\", \"rotate\", "
         "\"scale\" and \"matrix\""},
        {R"(, "lights": [{"type": "area", "color": [1, 1, 1]}])",
         "$.lights[0].type: found \"area\", expected \"point\", \"directional\" or \"spot\", the "
         "lights that are rendered"},
        {R"(, "lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1],
            "color": [1, 1, 1], "inner_angle": 50}])",
         "$.lights[0].inner_angle: found 50, expected a number from 0 to 45"},
    };
    for (const Case& c : kCases) {
        const std::string found = complaint(c.members);
        EXPECT_EQ(found.substr(0, std::string(c.complaint).size()), c.complaint) << c.members;
    }
    EXPECT_EQ(error_of([&] { read_world(dir_.write("s.json", R"({"boxwood": 3})")); }),
              "ParseError " + (dir_ / "s.json").string() +
                  ":$.boxwood: found 3, expected 2, the version of scene files that is read");
}

TEST_F(SceneDescription, an_upgraded_classic_scene_is_the_same_world) {
    write_mesh(dir_ / "ball.off", generate_icosphere(20));
    const std::string text = R"({
        "Scene": {"Background": [0, 0.5, 1], "Ambient": [0.1, 0.2, 0.3]},
        "Camera": {"IsPerspective": true, "Position": [0.1, 0.7, 2.3], "FieldOfView": 0.7854,
                   "FocalLength": 2.1, "LensRadius": 0.05},
        "Materials": [{"Ambient": [0.1, 0.1, 0.1], "Diffuse": [0.5, 0.5, 0.5],
                       "Specular": [0.2, 0.2, 0.2], "Mirror": [0.3, 0, 0],
                       "Refraction": [0, 0.4, 0], "RefractionIndex": 1.5, "Shininess": 20}],
        "Lights": [{"Position": [1, 5, 2], "Color": [9, 8, 7]}],
        "Objects": [
            {"Type": "Sphere", "Material": 0, "Position": [0, 1, 0], "Radius": 0.5},
            {"Type": "Parallelogram", "Material": 0,
             "Origin": [-1, 0, 0], "U": [2, 0, 0], "V": [0, 0, 2]},
            {"Type": "Mesh", "Material": 0, "Path": "ball.off"}]})";
    const World old = read_world(dir_.write("old.json", text));
    const World now = read_world(
        dir_.write("new.json", upgraded_classic_scene(JsonReader::parse(text, "old.json"))));
    EXPECT_EQ(now.background, old.background);
    EXPECT_EQ(now.ambient, old.ambient);
    EXPECT_EQ(now.camera.position, old.camera.position);
    EXPECT_EQ(now.camera.right, old.camera.right);
    EXPECT_EQ(now.camera.up, old.camera.up);
    EXPECT_EQ(now.camera.back, old.camera.back);
    EXPECT_EQ(now.camera.field_of_view, old.camera.field_of_view);
    EXPECT_EQ(now.camera.focal_length, old.camera.focal_length);
    EXPECT_EQ(now.camera.lens_radius, old.camera.lens_radius);
    EXPECT_EQ(now.camera.pixel_spread, old.camera.pixel_spread);
    EXPECT_EQ(now.picture.encoding, old.picture.encoding);
    EXPECT_EQ(now.picture.integrator, old.picture.integrator);
    EXPECT_EQ(now.lights[0].color, old.lights[0].color);
    EXPECT_EQ(now.spheres[0].center, old.spheres[0].center);
    ASSERT_EQ(now.objects.size(), old.objects.size());
    for (std::size_t i = 0; i < now.objects.size(); ++i)
        EXPECT_EQ(now.meshes[now.objects[i].mesh].vertices,
                  old.meshes[old.objects[i].mesh].vertices);
    const Material &a = now.materials[0], &b = old.materials[0];
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.diffuse, b.diffuse);
    EXPECT_EQ(a.mirror, b.mirror);
    EXPECT_EQ(a.refraction, b.refraction);
    EXPECT_EQ(a.shininess, b.shininess);
    EXPECT_EQ(a.is_two_sided, b.is_two_sided);
}

/// Not every angle in radians is one in degrees, to the last bit.
TEST(Degrees, give_back_the_radians_they_came_from_where_they_can) {
    int exact = 0;
    for (int i = 1; i < 3142; ++i) {
        const double angle = i / 1000.0;
        EXPECT_DOUBLE_EQ(radians(degrees(angle)), angle);
        exact += radians(degrees(angle)) == angle;
    }
    EXPECT_GT(exact, 2000);
    EXPECT_EQ(radians(degrees(0.7854)), 0.7854);
}

}  // namespace
}  // namespace boxwood
