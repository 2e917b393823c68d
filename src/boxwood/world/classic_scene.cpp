// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/classic_scene.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include "boxwood/mesh/mesh_file.h"
#include "boxwood/world/json_reader.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// Where to look for the files that a scene names.
struct Folders {
    fs::path scene;
    fs::path data;
};

Camera read_camera(const JsonReader& json) {
    json.expect_keys({"IsPerspective", "Position", "FieldOfView", "FocalLength", "LensRadius"});
    Camera camera;
    camera.is_perspective = json["IsPerspective"].boolean();
    camera.position = json["Position"].vec3();
    camera.field_of_view = json["FieldOfView"].number_above(0);
    if (camera.field_of_view >= std::numbers::pi) json["FieldOfView"].fail("an angle below pi");
    camera.focal_length = json["FocalLength"].number_above(0);
    camera.lens_radius = json["LensRadius"].number_at_least(0);
    return camera;
}

Material read_material(const JsonReader& json) {
    json.expect_keys(
        {"Ambient", "Diffuse", "Specular", "Mirror", "Refraction", "RefractionIndex", "Shininess"});
    return {.ambient = json["Ambient"].vec3(),
            .diffuse = json["Diffuse"].vec3(),
            .specular = json["Specular"].vec3(),
            .mirror = json["Mirror"].vec3(),
            .refraction = json["Refraction"].vec3(),
            .refraction_index = json["RefractionIndex"].number_above(0),
            .shininess = json["Shininess"].number_at_least(0)};
}

PointLight read_light(const JsonReader& json) {
    json.expect_keys({"Position", "Color"});
    return {.position = json["Position"].vec3(), .color = json["Color"].vec3()};
}

MeshData read_mesh_of(const JsonReader& json, const Folders& folders) {
    const std::string name = json["Path"].string();
    std::vector<fs::path> places = {folders.scene / name};
    if (!folders.data.empty()) places.push_back(folders.data / name);
    for (const fs::path& place : places) {
        std::error_code ignored;
        // The system would take a zero byte for the end of the name.
        const bool is_name = name.find('\0') == name.npos;
        if (is_name && fs::exists(place, ignored)) return read_mesh(place);
    }
    json["Path"].fail("a mesh file beside the scene or in the data folder");
}

/// Two triangles on the four corners, counter-clockwise as seen from the tip of u x v.
TriangleMesh make_parallelogram(const Vec3d& origin, const Vec3d& u, const Vec3d& v) {
    return {.vertices = {origin, origin + u, origin + u + v, origin + v},
            .faces = {{0, 1, 2}, {0, 2, 3}}};
}

void read_object(const JsonReader& json, const Folders& folders, World& world) {
    const auto material = [&] { return json["Material"].index(world.materials.size()); };
    const std::string type = json["Type"].string();
    if (type == "Sphere") {
        json.expect_keys({"Type", "Material", "Position", "Radius"});
        world.spheres.push_back({.center = json["Position"].vec3(),
                                 .radius = json["Radius"].number_above(0),
                                 .material = material()});
    } else if (type == "Parallelogram") {
        json.expect_keys({"Type", "Material", "Origin", "U", "V"});
        world.meshes.push_back(
            {make_parallelogram(json["Origin"].vec3(), json["U"].vec3(), json["V"].vec3()),
             material()});
    } else if (type == "Mesh") {
        json.expect_keys({"Type", "Material", "Path"});
        const std::size_t index = material();
        MeshData mesh = read_mesh_of(json, folders);
        world.warnings.append(mesh.warnings);
        world.meshes.push_back({std::move(mesh), index});
    } else {
        json["Type"].fail("\"Sphere\", \"Parallelogram\" or \"Mesh\"");
    }
}

}  // namespace

World read_classic_scene(const fs::path& path, const fs::path& data_folder) {
    const JsonReader json = JsonReader::read_file(path);
    json.expect_keys({"Scene", "Camera", "Materials", "Lights", "Objects"});
    json["Scene"].expect_keys({"Background", "Ambient"});

    World world;
    world.background = json["Scene"]["Background"].vec3();
    world.ambient = json["Scene"]["Ambient"].vec3();
    world.camera = read_camera(json["Camera"]);
    for (const JsonReader& item : json["Materials"].array())
        world.materials.push_back(read_material(item));
    for (const JsonReader& item : json["Lights"].array()) world.lights.push_back(read_light(item));
    for (const JsonReader& item : json["Objects"].array())
        read_object(item, {path.parent_path(), data_folder}, world);
    return world;
}

}  // namespace boxwood
