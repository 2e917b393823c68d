// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/gltf_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/mesh/gltf/document.h"
#include "boxwood/mesh/gltf/gltf_mesh.h"
#include "boxwood/mesh/gltf/gltf_nodes.h"
#include "boxwood/world/gltf_materials.h"
#include "boxwood/world/studio.h"

namespace boxwood {

namespace {

/// What a surface sends on of light that arrives evenly, as glTF counts light and Phong's terms
/// don't.
constexpr double kPerDirection = 1 / std::numbers::pi;

class WorldReader {
public:
    WorldReader(const MeshSource& source, const ReadOptions& options)
        : document_(source, options) {}

    World read() {
        world_.picture = studio_picture();
        add_gltf_textures(document_, world_);
        add_gltf_materials(document_, world_);
        if (document_.count("nodes") == 0) {
            for (std::size_t i = 0; i < document_.count("meshes"); ++i)
                add_object(document_.item("meshes", i), i, AffineMap::Identity());
        }
        for_each_gltf_node(document_, [this](const JsonReader& node, const AffineMap& to_world) {
            if (const auto mesh = node.find("mesh"))
                add_object(node, document_.index(*mesh, "meshes"), to_world);
            if (const auto camera = node.find("camera"))
                add_camera(document_.item("cameras", document_.index(*camera, "cameras")),
                           to_world);
            add_light(node, to_world);
            if (node.find("skin"))
                world_.warnings.add("skins, left in their own pose", document_.name(), node.path(),
                                    "found a skin, expected none");
        });
        if (document_.json().find("animations"))
            world_.warnings.add("animations, left out", document_.name(), "$.animations",
                                "found animations, expected none");

        if (world_.cameras.empty()) {
            frame(world_, UpAxis::y);
        } else {
            use_camera(world_, 0);
        }
        if (world_.lights.empty()) light_studio(world_, UpAxis::y);
        return std::move(world_);
    }

private:
    void add_object(const JsonReader& place, std::size_t mesh, const AffineMap& to_world) {
        try {
            (void)Placement(to_world);
        } catch (const InvalidInput& error) {
            world_.warnings.add("objects without an extent, left out", document_.name(),
                                place.path(), error.what());
            return;
        }
        const auto [found, is_new] = meshes_.emplace(mesh, world_.meshes.size());
        if (is_new) {
            MeshData data = read_gltf_mesh(document_, mesh);
            world_.warnings.append(std::exchange(data.warnings, {}));
            world_.meshes.push_back(std::move(data));
        }
        std::vector<std::size_t> materials(world_.materials.size());
        std::iota(materials.begin(), materials.end(), std::size_t{0});
        world_.objects.push_back(
            {.mesh = found->second, .materials = std::move(materials), .to_world = to_world});
    }

    void add_camera(const JsonReader& value, const AffineMap& to_world) {
        NamedCamera named;
        if (const auto name = value.find("name")) named.name = name->string();
        Camera& camera = named.camera;
        const Vec3d back = to_world.linear().col(2), up = to_world.linear().col(1);
        camera.look_at(to_world.translation(), to_world.translation() - back, up);
        camera.pixel_spread = 1;
        const JsonReader type = value["type"];
        if (type.string() == "perspective") {
            const JsonReader perspective = value["perspective"];
            const JsonReader angle = perspective["yfov"];
            camera.field_of_view = angle.number_above(0);
            if (camera.field_of_view >= std::numbers::pi) angle.fail("an angle below pi");
            if (const auto aspect = perspective.find("aspectRatio"))
                named.aspect = aspect->number_within(0.01, 100);
        } else if (type.string() == "orthographic") {
            camera.is_perspective = false;
            const double half_height = value["orthographic"]["ymag"].number_above(0);
            camera.field_of_view = 2 * std::atan(half_height);
            named.aspect = std::clamp(value["orthographic"]["xmag"].number_above(0) / half_height,
                                      0.01, 100.0);
        } else {
            type.fail("\"perspective\" or \"orthographic\"");
        }
        if (!camera.right.allFinite() || camera.right.isZero(0)) {
            world_.warnings.add("cameras without a direction, left out", document_.name(),
                                value.path(), "found no direction, expected one");
            return;
        }
        world_.cameras.push_back(std::move(named));
    }

    /// By KHR_lights_punctual.
    void add_light(const JsonReader& node, const AffineMap& to_world) {
        const auto find = [](const JsonReader& value) -> std::optional<JsonReader> {
            const auto extensions = value.find("extensions");
            return extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
        };
        const auto named = find(node);
        if (!named) return;
        const auto all = find(document_.json());
        const std::vector<JsonReader> lights =
            all ? (*all)["lights"].array() : std::vector<JsonReader>();
        const JsonReader value = lights[(*named)["light"].index(lights.size())];

        Light light;
        light.position = to_world.translation();
        const Vec3d forward = -to_world.linear().col(2);
        light.direction = forward.normalized();
        const auto color = value.find("color");
        const auto intensity = value.find("intensity");
        light.color = (color ? color->vec3() : Color(Color::Ones())) *
                      (intensity ? intensity->number_at_least(0) : 1) * kPerDirection;
        const JsonReader type = value["type"];
        if (type.string() == "directional") {
            light.kind = LightKind::directional;
        } else if (type.string() == "spot") {
            light.kind = LightKind::spot;
            const auto spot = value.find("spot");
            const auto angle = [&](const char* key, double otherwise) {
                const auto number = spot ? spot->find(key) : std::nullopt;
                return number ? number->number_within(0, std::numbers::pi / 2) : otherwise;
            };
            light.cos_inner = std::cos(angle("innerConeAngle", 0));
            light.cos_outer = std::cos(angle("outerConeAngle", std::numbers::pi / 4));
        } else if (type.string() != "point") {
            type.fail("\"point\", \"spot\" or \"directional\"");
        }
        if (!light.position.allFinite() || !light.direction.allFinite()) return;
        world_.lights.push_back(light);
    }

    GltfDocument document_;
    World world_;
    std::map<std::size_t, std::size_t> meshes_;  ///< those of the file, in the world
};

}  // namespace

World parse_gltf_world(const MeshSource& source, const ReadOptions& options) {
    World world = WorldReader(source, options).read();
    return world;
}

}  // namespace boxwood
