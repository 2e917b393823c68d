// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/read_world.h"

#include <algorithm>
#include <string>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/file_content.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/side_file.h"
#include "boxwood/world/classic_scene.h"
#include "boxwood/world/gltf_world.h"
#include "boxwood/world/mtl.h"
#include "boxwood/world/scene_description.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// The materials that a mesh file names, with what is wrong with them.
struct Palette {
    std::vector<Material> materials;
    std::vector<Texture> textures;
    Warnings warnings;
};

Palette read_palette(const fs::path& mesh_path, const MeshData& mesh, const ReadOptions& options) {
    Palette palette;
    for (const std::string& name : mesh.attributes.material_files) {
        const fs::path path = mesh_path.parent_path() / name;
        try {
            if (const auto refusal =
                    refusal_of(mesh_path.parent_path(), name, options.allow_outside_files))
                throw IoError(name, "found the name of a material file, expected " + *refusal);
            const FileContent content(path, options.limits);
            MtlLibrary library = parse_mtl({content.bytes(), path}, options);
            for (Material& material : library.materials) {
                if (material.color_texture)
                    material.color_texture->texture += palette.textures.size();
                palette.materials.push_back(std::move(material));
            }
            for (Texture& texture : library.textures)
                palette.textures.push_back(std::move(texture));
            palette.warnings.append(library.warnings);
        } catch (const Error& error) {
            palette.warnings.add("material files that can't be read, done without", "", "",
                                 error.what());
        }
    }
    return palette;
}

World read_mesh_world(const fs::path& path, const WorldOptions& options) {
    MeshData mesh = read_mesh(path, options.read);
    Palette palette = read_palette(path, mesh, options.read);
    mesh.warnings.append(palette.warnings);
    const bool is_z_up = mesh_format_of(path).extension == ".stl";
    return world_of_mesh(std::move(mesh), options.up.value_or(is_z_up ? UpAxis::z : UpAxis::y),
                         std::move(palette.materials), std::move(palette.textures));
}

/// Of version 2 when it says so, else classic.
World read_scene_file(const fs::path& path, const WorldOptions& options) {
    const FileContent content(path, options.read.limits);
    const JsonReader json = JsonReader::parse(content.bytes(), path.string(), options.read.limits);
    const bool is_classic = !json.is_object() || !json.find("boxwood");
    return is_classic ? read_classic_scene(json, path, options.read, options.data_folder)
                      : read_scene_description(json, path, options.read, options.data_folder);
}

World read_unrepaired(const fs::path& path, const WorldOptions& options) {
    if (path.extension() == ".json") return read_scene_file(path, options);
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw IoError(path.string(), "found a directory, expected a file");
    const MeshFormat& format = mesh_format_of(path);
    if (format.extension != ".gltf" && format.extension != ".glb")
        return read_mesh_world(path, options);
    const FileContent content(path, options.read.limits);
    return parse_gltf_world({content.bytes(), path}, options.read);
}

}  // namespace

World world_of_mesh(MeshData mesh, UpAxis up, std::vector<Material> materials,
                    std::vector<Texture> textures) {
    World world;
    world.picture = studio_picture();
    world.warnings = std::exchange(mesh.warnings, {});
    world.materials = std::move(materials);
    world.textures = std::move(textures);

    MeshObject object;
    const auto place_of = [&](const std::string& name) {
        const auto found = std::find_if(world.materials.begin(), world.materials.end(),
                                        [&](const Material& m) { return m.name == name; });
        return static_cast<std::size_t>(found - world.materials.begin());
    };
    const std::size_t none = world.materials.size();
    world.materials.push_back(clay());
    if (!mesh.attributes.materials.is_empty()) {
        object.materials.clear();
        for (const std::string& name : mesh.attributes.materials.names)
            object.materials.push_back(std::min(place_of(name), none));
    } else {
        object.materials = {none};
    }
    // Colors of vertices are the surface's own, not a tint of clay.
    if (!mesh.attributes.colors.is_empty()) {
        Material& colored = world.materials[none];
        colored.ambient = colored.diffuse = Color::Ones();
    }
    world.objects.push_back(std::move(object));
    world.meshes.push_back(std::move(mesh));
    frame(world, up);
    light_studio(world, up);
    return world;
}

World read_world(const fs::path& path, const WorldOptions& options) {
    World world = read_unrepaired(path, options);
    for (MeshData& mesh : world.meshes) repair(mesh, options.repair);
    return world;
}

}  // namespace boxwood
