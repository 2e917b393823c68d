// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/world/read_world.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kTriangleOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

json valid_scene() {
    return json::parse(R"({
        "Scene": {"Background": [0.3, 0.4, 0.9], "Ambient": [0.1, 0.2, 0.3]},
        "Camera": {"IsPerspective": false, "Position": [1, 2, 3], "FieldOfView": 0.7854,
                   "FocalLength": 2.5, "LensRadius": 0.08},
        "Materials": [
            {"Ambient": [0, 0.5, 0], "Diffuse": [0.5, 0.6, 0.7], "Specular": [0.2, 0.3, 0.4],
             "Mirror": [0.7, 0.8, 0.9], "Refraction": [0.01, 0.02, 0.03],
             "RefractionIndex": 1.5, "Shininess": 256},
            {"Ambient": [1, 1, 1], "Diffuse": [1, 1, 1], "Specular": [1, 1, 1],
             "Mirror": [0, 0, 0], "Refraction": [0, 0, 0], "RefractionIndex": 1, "Shininess": 0}],
        "Lights": [{"Position": [8, 9, 10], "Color": [16, 17, 18]}],
        "Objects": [
            {"Type": "Sphere", "Material": 1, "Position": [5, 0, 1], "Radius": 0.5},
            {"Type": "Parallelogram", "Material": 0, "Origin": [1, 1, 1], "U": [2, 0, 0],
             "V": [0, 3, 0]},
            {"Type": "Mesh", "Material": 1, "Path": "triangle.off"}]
    })");
}

class ClassicScene : public testing::Test {
protected:
    ClassicScene() { dir_.write("triangle.off", kTriangleOff); }

    World read(const json& scene) const { return read_text(scene.dump(2)); }
    World read_text(const std::string& text) const {
        return read_world(dir_.write("scene.json", text));
    }

    /// The message of what reading throws, less the file's name.
    template <class Exception = ParseError>
    std::string message_of(const std::string& text) const {
        try {
            read_text(text);
        } catch (const Exception& error) {
            const std::string file = (dir_ / "scene.json").string();
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            return message.starts_with(file) ? message.substr(file.size()) : message;
        }
        return "nothing thrown";
    }

    void expect_fault(const std::function<void(json&)>& change, const std::string& message) const {
        json scene = valid_scene();
        change(scene);
        EXPECT_EQ(message_of(scene.dump()), message);
    }

    TempDir dir_;
};

TEST_F(ClassicScene, every_value_arrives) {
    const World world = read(valid_scene());
    EXPECT_EQ(world.background, Color(0.3, 0.4, 0.9));
    EXPECT_EQ(world.ambient, Color(0.1, 0.2, 0.3));
    EXPECT_FALSE(world.camera.is_perspective);
    EXPECT_EQ(world.camera.position, Vec3d(1, 2, 3));
    EXPECT_EQ(world.camera.field_of_view, 0.7854);
    EXPECT_EQ(world.camera.focal_length, 2.5);
    EXPECT_EQ(world.camera.lens_radius, 0.08);
    EXPECT_EQ(world.camera.pixel_spread, 0);
    EXPECT_EQ(world.camera.right, Vec3d::UnitX());
    EXPECT_EQ(world.camera.up, Vec3d::UnitY());
    EXPECT_EQ(world.camera.back, Vec3d::UnitZ());

    ASSERT_EQ(world.materials.size(), 2u);
    const Material& material = world.materials[0];
    EXPECT_EQ(material.ambient, Color(0, 0.5, 0));
    EXPECT_EQ(material.diffuse, Color(0.5, 0.6, 0.7));
    EXPECT_EQ(material.specular, Color(0.2, 0.3, 0.4));
    EXPECT_EQ(material.mirror, Color(0.7, 0.8, 0.9));
    EXPECT_EQ(material.refraction, Color(0.01, 0.02, 0.03));
    EXPECT_EQ(material.refraction_index, 1.5);
    EXPECT_EQ(material.shininess, 256);

    ASSERT_EQ(world.lights.size(), 1u);
    EXPECT_EQ(world.lights[0].position, Vec3d(8, 9, 10));
    EXPECT_EQ(world.lights[0].color, Color(16, 17, 18));

    ASSERT_EQ(world.spheres.size(), 1u);
    EXPECT_EQ(world.spheres[0].center, Vec3d(5, 0, 1));
    EXPECT_EQ(world.spheres[0].radius, 0.5);
    EXPECT_EQ(world.spheres[0].material, 1u);

    ASSERT_EQ(world.meshes.size(), 2u);
    EXPECT_EQ(world.objects[0].materials, std::vector<std::size_t>{0});
    EXPECT_EQ(world.meshes[0].faces.size(), 2u);
    EXPECT_EQ(world.objects[1].materials, std::vector<std::size_t>{1});
    EXPECT_EQ(world.meshes[1].vertices.size(), 3u);
}

TEST_F(ClassicScene, parallelogram_spans_its_corners_and_faces_u_cross_v) {
    const World world = read(valid_scene());
    const MeshView mesh = world.meshes[0];
    const Box3d box = bounds(mesh);
    EXPECT_EQ(box, (Box3d{Vec3d(1, 1, 1), Vec3d(3, 4, 1)}));
    for (std::size_t face = 0; face < 2; ++face)
        EXPECT_EQ(geometric_normal(mesh, face), Vec3d(0, 0, 1));
}

TEST_F(ClassicScene, lists_may_be_empty) {
    json scene = valid_scene();
    scene["Objects"] = json::array();
    scene["Lights"] = json::array();
    scene["Materials"] = json::array();
    const World world = read(scene);
    EXPECT_TRUE(world.materials.empty() && world.lights.empty());
    EXPECT_TRUE(world.meshes.empty() && world.spheres.empty());
}

TEST_F(ClassicScene, meshes_are_looked_up_beside_the_scene_then_in_the_data_folder) {
    const TempDir data;
    data.write("other.off", kTriangleOff);
    data.write("triangle.off", "not read");
    json scene = valid_scene();
    scene["Objects"][1] = {{"Type", "Mesh"}, {"Material", 0}, {"Path", "other.off"}};
    const fs::path path = dir_.write("scene.json", scene.dump());
    EXPECT_THROW(read_world(path), ParseError);
    EXPECT_EQ(read_world(path, {.data_folder = data.path()}).meshes.size(), 2u);

    scene["Objects"][1]["Path"] = (data / "other.off").string();
    EXPECT_EQ(read(scene).meshes.size(), 2u) << "absolute";
}

TEST_F(ClassicScene, every_key_is_required) {
    const std::vector<std::string> objects = {"/Scene",       "/Camera",    "/Materials/0",
                                              "/Materials/1", "/Lights/0",  "/Objects/0",
                                              "/Objects/1",   "/Objects/2", ""};
    const auto as_path = [](const std::string& pointer) {
        std::string path = "$";
        for (const char c : pointer) {
            if (c == '/') {
                path += '.';
            } else if (c >= '0' && c <= '9') {
                path.back() = '[';
                path += std::string(1, c) + "]";
            } else {
                path += c;
            }
        }
        return path;
    };
    for (const std::string& object : objects) {
        const json::json_pointer pointer(object);
        const json original = valid_scene()[pointer];
        for (const auto& [key, value] : original.items()) {
            json scene = valid_scene();
            scene[pointer].erase(key);
            const std::string message = message_of(scene.dump());
            // Type tells which other keys there are, so it is asked for by itself.
            const std::string expected =
                key == "Type"
                    ? ":" + as_path(object) + ": found an object, expected key 'Type'"
                    : ":" + as_path(object) + ": found no key '" + key + "', expected one";
            EXPECT_EQ(message, expected);

            // An unknown key in the same place, and one that differs in case alone.
            for (const std::string& unknown : {std::string("Unknown"), "x" + key}) {
                scene = valid_scene();
                scene[pointer][unknown] = 1;
                EXPECT_EQ(message_of(scene.dump())
                              .find(":" + as_path(object) + ": found unknown key \"" + unknown +
                                    "\", expected "),
                          0u)
                    << message_of(scene.dump());
            }

            // A value of no use to any key.
            for (const json& wrong : {json(nullptr), json::object({{"a", 1}})}) {
                scene = valid_scene();
                scene[pointer][key] = wrong;
                const std::string wrong_message = message_of(scene.dump());
                EXPECT_EQ(wrong_message.find(":" + as_path(object) + "." + key + ": found "), 0u)
                    << key << ": " << wrong_message;
            }
        }
    }
}

TEST_F(ClassicScene, faults_are_reported_with_their_path_what_was_found_and_expected) {
    const struct {
        const char* pointer;
        json value;
        const char* message;
    } kFaults[] = {
        {"/Scene", 7, ":$.Scene: found 7, expected an object"},
        {"/Scene", json::array(), ":$.Scene: found an array of 0, expected an object"},
        {"/Scene/Background",
         {1, 2},
         ":$.Scene.Background: found an array of 2, expected an array of 3 numbers"},
        {"/Scene/Background",
         {1, 2, 3, 4},
         ":$.Scene.Background: found an array of 4, expected an array of 3 numbers"},
        {"/Scene/Background", 0.5,
         ":$.Scene.Background: found 0.5, expected an array of 3 numbers"},
        {"/Scene/Ambient", {1, "2", 3}, ":$.Scene.Ambient[1]: found \"2\", expected a number"},
        {"/Scene/Ambient", {1, 2, nullptr}, ":$.Scene.Ambient[2]: found null, expected a number"},
        {"/Camera/IsPerspective", 1, ":$.Camera.IsPerspective: found 1, expected true or false"},
        {"/Camera/IsPerspective", "true",
         ":$.Camera.IsPerspective: found \"true\", expected true or false"},
        {"/Camera/FieldOfView", 0, ":$.Camera.FieldOfView: found 0, expected a number above 0"},
        {"/Camera/FieldOfView", -1, ":$.Camera.FieldOfView: found -1, expected a number above 0"},
        {"/Camera/FieldOfView", 3.15,
         ":$.Camera.FieldOfView: found 3.15, expected an angle below pi"},
        {"/Camera/FieldOfView", 45, ":$.Camera.FieldOfView: found 45, expected an angle below pi"},
        {"/Camera/FieldOfView", true,
         ":$.Camera.FieldOfView: found true, expected a number above 0"},
        {"/Camera/FocalLength", 0, ":$.Camera.FocalLength: found 0, expected a number above 0"},
        {"/Camera/LensRadius", -0.5,
         ":$.Camera.LensRadius: found -0.5, expected a number of at least 0"},
        {"/Materials", 3, ":$.Materials: found 3, expected an array"},
        {"/Materials/1", 3, ":$.Materials[1]: found 3, expected an object"},
        {"/Materials/0/RefractionIndex", 0,
         ":$.Materials[0].RefractionIndex: found 0, expected a number above 0"},
        {"/Materials/1/Shininess", -1,
         ":$.Materials[1].Shininess: found -1, expected a number of at least 0"},
        {"/Lights", "none", ":$.Lights: found \"none\", expected an array"},
        {"/Lights/0/Color", {1, 2, true}, ":$.Lights[0].Color[2]: found true, expected a number"},
        {"/Objects", nullptr, ":$.Objects: found null, expected an array"},
        {"/Objects/0/Type", "Cube",
         ":$.Objects[0].Type: found \"Cube\", expected \"Sphere\", \"Parallelogram\" or \"Mesh\""},
        {"/Objects/0/Type", "sphere",
         ":$.Objects[0].Type: found \"sphere\", expected \"Sphere\", \"Parallelogram\" or "
         "\"Mesh\""},
        {"/Objects/0/Type", 1, ":$.Objects[0].Type: found 1, expected a string"},
        {"/Objects/0/Material", 2,
         ":$.Objects[0].Material: found 2, expected a whole number from 0 to 1"},
        {"/Objects/1/Material", -1,
         ":$.Objects[1].Material: found -1, expected a whole number from 0 to 1"},
        {"/Objects/2/Material", 0.5,
         ":$.Objects[2].Material: found 0.5, expected a whole number from 0 to 1"},
        {"/Objects/2/Material", 18446744073709551615u,
         ":$.Objects[2].Material: found 18446744073709551615, expected a whole number from 0 to 1"},
        {"/Objects/2/Material", "0",
         ":$.Objects[2].Material: found \"0\", expected a whole number from 0 to 1"},
        {"/Materials", json::array(),
         ":$.Objects[0].Material: found 1, expected nothing, as there is nothing to choose from"},
        {"/Objects/0/Radius", 0, ":$.Objects[0].Radius: found 0, expected a number above 0"},
        {"/Objects/0/Radius", -2, ":$.Objects[0].Radius: found -2, expected a number above 0"},
        {"/Objects/2/Path", 3, ":$.Objects[2].Path: found 3, expected a string"},
        {"/Objects/2/Path", "missing.off",
         ":$.Objects[2].Path: found \"missing.off\", expected a mesh file beside the scene or in "
         "the data folder"},
        {"/Objects/2/Path", std::string("triangle.off\0", 13),
         ":$.Objects[2].Path: found \"triangle.off\\u0000\", expected a mesh file beside the scene "
         "or in the data folder"},
        {"/Objects/2/Path", std::string(5000, 'a') + ".off",
         ":$.Objects[2].Path: found \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...\", expected a mesh "
         "file beside the scene or in the data folder"},
    };
    for (const auto& [pointer, value, message] : kFaults) {
        SCOPED_TRACE(pointer);
        const json::json_pointer place{std::string(pointer)};
        expect_fault([&, fault = value](json& scene) { scene[place] = fault; }, message);
    }
}

TEST_F(ClassicScene, document_that_is_no_object_is_reported) {
    EXPECT_EQ(message_of("[1, 2]"), ":$: found an array of 2, expected an object");
    EXPECT_EQ(message_of("12"), ":$: found 12, expected an object");
    EXPECT_EQ(message_of("null"), ":$: found null, expected an object");
}

TEST_F(ClassicScene, key_twice_in_one_object_is_reported_with_the_line_of_the_second) {
    std::string text = valid_scene().dump(2);
    const std::size_t first = text.find("\"FocalLength\"");
    text.insert(first, "\"LensRadius\": 1,\n");
    const std::size_t second = text.find("\"LensRadius\"", first + 5);
    const auto line = 1 + std::count(text.begin(), text.begin() + second, '\n');
    EXPECT_EQ(message_of(text),
              ":" + std::to_string(line) +
                  ": found key \"LensRadius\" twice in one object, expected it once");
    EXPECT_EQ(message_of("{\"\": 1,\n\"\": 2}"),
              ":2: found key \"\" twice in one object, expected it once");
    EXPECT_EQ(message_of("{\"a\": {\"b\": 1}, \"b\": 1,\n\n\"\\u0061\"\n: 1}"),
              ":3: found key \"a\" twice in one object, expected it once");
}

TEST_F(ClassicScene, what_is_no_json_is_reported_with_line_found_and_expected) {
    const std::string value = "expected '[', '{', or a literal";
    const std::pair<std::string, std::string> kFaults[] = {
        {"", ":1: found end of input, " + value},
        {"\n\n", ":3: found end of input, " + value},
        {"{\n\"Scene\": 01}", ":2: found number literal, expected '}'"},
        {"{\n\n\"Scene\": {},\n}", ":4: found '}', expected string literal"},
        {"{\"a\"\n1}", ":2: found number literal, expected ':'"},
        {"[1 2]", ":1: found number literal, expected ']'"},
        {"{} {}", ":1: found '{', expected end of input"},
        {"{\"Scene\":\nNaN}", ":2: found \"NaN\", expected JSON (invalid literal)"},
        {"{\"Scene\":\nnul}", ":2: found \"nul\", expected JSON (invalid literal)"},
        {"truth", ":1: found \"truth\", expected JSON (invalid literal)"},
        {"tru", ":1: found \"tru\", expected JSON (invalid literal)"},
        {"{\"Scene\":\n?}", ":2: found \"?\", expected JSON (invalid literal)"},
        {"{\n?}", ":2: found \"?\", expected string literal (invalid literal)"},
        {"{\"'; expected \" ?}", ":1: found \"?\", expected ':' (invalid literal)"},
        {"[\n1.\n]",
         ":2: found \"1.<U+000A>\", expected JSON (invalid number; expected digit after '.')"},
        {"[\"a\nb\"]",
         ":1: found \"\\\"a<U+000A>\", expected JSON (invalid string: control character U+000A "
         "(LF) "
         "must be escaped to \\u000A or \\n)"},
        {"\n[\"open",
         ":2: found \"\\\"open\", expected JSON (invalid string: missing closing quote)"},
        {"{\"a\": \"\xff\xfe\"}",
         ":1: found \"\\\"\\ufffd\", expected JSON (invalid string: ill-formed UTF-8 byte)"},
        {"\xef\xbb{}",
         ":1: found \"\\ufffd{\", expected JSON (invalid BOM; must be 0xEF 0xBB 0xBF if given)"},
        {std::string("{\n\0}", 4), ":2: found a zero byte, expected text"},
        {std::string("{}\0", 3), ":1: found a zero byte, expected text"},
    };
    for (const auto& [text, message] : kFaults) EXPECT_EQ(message_of(text), message) << text;
}

TEST_F(ClassicScene, document_cut_short_is_reported_with_its_line) {
    const std::string text = valid_scene().dump(2);
    for (std::size_t length = 0; length < text.size(); length += 7) {
        const std::string part = text.substr(0, length);
        const auto line = 1 + std::count(part.begin(), part.end(), '\n');
        const std::string message = message_of(part);
        EXPECT_EQ(message.find(":" + std::to_string(line) + ": found "), 0u) << message;
        EXPECT_NE(message.find(", expected "), std::string::npos) << message;
    }
}

TEST_F(ClassicScene, numbers_beyond_double_are_reported_with_their_line) {
    const std::string expected = ", expected a number of at most 1.8e308 in size";
    std::string text = valid_scene().dump(2);
    const std::string number = "0.7854";
    const std::size_t place = text.find(number);
    text.replace(place, number.size(), "1e999");
    const auto line = 1 + std::count(text.begin(), text.begin() + place, '\n');
    EXPECT_EQ(message_of(text), ":" + std::to_string(line) + ": found 1e999" + expected);

    EXPECT_EQ(message_of("1e309"), ":1: found 1e309" + expected);
    EXPECT_EQ(message_of("\n-1e+309\n"), ":2: found -1e+309" + expected);
    EXPECT_EQ(message_of("[1,\n2,-1E999,\n4]"), ":2: found -1E999" + expected);
    EXPECT_EQ(message_of("[\n" + std::string(400, '9') + "\n]"),
              ":2: found " + std::string(36, '9') + "..." + expected);
}

TEST_F(ClassicScene, deep_nesting_is_reported_and_no_crash) {
    for (const char* open : {"[", "{\"a\":"}) {
        std::string deep;
        for (int i = 0; i < 100'000; ++i) deep += open;
        EXPECT_EQ(message_of(deep).find(":1: "), 0u);
    }
    std::string whole = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_EQ(message_of(whole), ":1: found a value in 257 others, expected at most 256");
    whole = std::string(256, '[') + std::string(256, ']');
    EXPECT_EQ(message_of(whole), ":$: found an array of 1, expected an object");
}

TEST_F(ClassicScene, missing_files_and_directories_are_io_errors) {
    EXPECT_THROW(read_world(dir_ / "missing.json"), IoError);
    std::filesystem::create_directory(dir_ / "folder.json");
    EXPECT_THROW(read_world(dir_ / "folder.json"), IoError);
}

TEST_F(ClassicScene, faults_of_mesh_files_are_those_of_their_reader) {
    json scene = valid_scene();
    dir_.write("triangle.off", "OFF\n3 1 0\n0 0 0\n");
    EXPECT_THROW(read(scene), ParseError);
    fs::create_directory(dir_ / "folder.off");
    scene["Objects"][2]["Path"] = "folder.off";
    EXPECT_THROW(read(scene), IoError);
    dir_.write("mesh.xyz", kTriangleOff);
    scene["Objects"][2]["Path"] = "mesh.xyz";
    EXPECT_THROW(read(scene), InvalidInput);
    for (const char* no_file : {"", ".", "/"}) {
        scene["Objects"][2]["Path"] = no_file;
        EXPECT_THROW(read(scene), Error) << no_file;
    }
}

}  // namespace
}  // namespace boxwood
