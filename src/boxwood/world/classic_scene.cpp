// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/classic_scene.h"

#include <utility>
#include <vector>

#include "boxwood/core/json_reader.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/world/classic_parts.h"
#include "boxwood/world/parallelogram.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// Where to look for the files that a scene names.
struct Folders {
    fs::path scene;
    fs::path data;
    ReadOptions options;
};

MeshData read_mesh_of(const JsonReader& json, const Folders& folders) {
    const std::string name = json["Path"].string();
    std::vector<fs::path> places = {folders.scene / name};
    if (!folders.data.empty()) places.push_back(folders.data / name);
    for (const fs::path& place : places) {
        std::error_code ignored;
        // The system would take a zero byte for the end of the name.
        const bool is_name = name.find('\0') == name.npos;
        if (is_name && fs::exists(place, ignored)) return read_mesh(place, folders.options);
    }
    json["Path"].fail("a mesh file beside the scene or in the data folder");
}

void read_object(const JsonReader& json, const Folders& folders, World& world) {
    const ClassicType type = classic_type(json);
    const std::size_t material = json["Material"].index(world.materials.size());
    if (type == ClassicType::sphere) {
        world.spheres.push_back({.center = json["Position"].vec3(),
                                 .radius = json["Radius"].number_above(0),
                                 .material = material});
    } else if (type == ClassicType::parallelogram) {
        world.add_mesh(
            make_parallelogram(json["Origin"].vec3(), json["U"].vec3(), json["V"].vec3()),
            material);
    } else {
        MeshData mesh = read_mesh_of(json, folders);
        world.warnings.append(mesh.warnings);
        world.add_mesh(std::move(mesh), material);
    }
}

}  // namespace

World read_classic_scene(const JsonReader& json, const fs::path& path, const ReadOptions& options,
                         const fs::path& data_folder) {
    check_classic_keys(json);
    World world;
    world.background = json["Scene"]["Background"].vec3();
    world.ambient = json["Scene"]["Ambient"].vec3();
    world.camera = read_classic_camera(json["Camera"]);
    for (const JsonReader& item : json["Materials"].array())
        world.materials.push_back(read_classic_material(item));
    for (const JsonReader& item : json["Lights"].array())
        world.lights.push_back(read_classic_light(item));
    for (const JsonReader& item : json["Objects"].array())
        read_object(item, {path.parent_path(), data_folder, options}, world);
    return world;
}

}  // namespace boxwood
