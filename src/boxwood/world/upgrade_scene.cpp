// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "boxwood/world/classic_parts.h"
#include "boxwood/world/classic_scene.h"
#include "boxwood/world/degrees.h"

namespace boxwood {

namespace {

using Json = nlohmann::ordered_json;

/// Without negative zeros, which only puzzle readers.
Json array_of(const Vec3d& v) { return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}; }

/// The text with each array of numbers on one line.
std::string with_short_arrays(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        const std::size_t end = text.find_first_not_of("0123456789+-.eE, \n", i + 1);
        const bool is_short = text[i] == '[' && end != text.npos && text[end] == ']';
        if (!is_short || end == i + 1) continue;
        for (++i; i < end; ++i) {
            if (text[i] == '\n' || text[i] == ' ') continue;
            result += text[i] == ',' ? std::string(", ") : std::string(1, text[i]);
        }
        result += ']';
    }
    return result;
}

Json camera_of(const Camera& camera) {
    Json json;
    json["type"] = camera.is_perspective ? "perspective" : "orthographic";
    json["from"] = array_of(camera.position);
    json["direction"] = array_of(-camera.back);
    json["up"] = array_of(camera.up);
    json["pixel_spread"] = camera.pixel_spread;
    if (!camera.is_perspective) {
        json["height"] = 2 * camera.film(1, 1).half_height;
        return json;
    }
    json["field_of_view"] = degrees(camera.field_of_view);
    json["focus_distance"] = camera.focal_length;
    json["lens_radius"] = camera.lens_radius;
    return json;
}

Json material_of(const Material& material) {
    return {{"type", "phong"},
            {"ambient", array_of(material.ambient)},
            {"diffuse", array_of(material.diffuse)},
            {"specular", array_of(material.specular)},
            {"mirror", array_of(material.mirror)},
            {"refraction", array_of(material.refraction)},
            {"refraction_index", material.refraction_index},
            {"shininess", material.shininess},
            {"two_sided", material.is_two_sided}};
}

std::string name_of(const char* kind, std::size_t i) { return fmt::format("{} {}", kind, i); }

}  // namespace

std::string upgraded_classic_scene(const JsonReader& classic) {
    check_classic_keys(classic);
    Json json;
    json["boxwood"] = 2;
    json["film"] = {{"width", 640}, {"height", 480}, {"encoding", "linear"}};
    json["integrator"] = {{"type", "phong"}};
    json["background"] = array_of(classic["Scene"]["Background"].vec3());
    json["ambient"] = array_of(classic["Scene"]["Ambient"].vec3());
    json["camera"] = camera_of(read_classic_camera(classic["Camera"]));

    json["lights"] = Json::array();
    for (const JsonReader& item : classic["Lights"].array()) {
        const Light light = read_classic_light(item);
        json["lights"].push_back({{"type", "point"},
                                  {"position", array_of(light.position)},
                                  {"color", array_of(light.color)}});
    }
    json["materials"] = Json::object();
    const std::vector<JsonReader> materials = classic["Materials"].array();
    for (std::size_t i = 0; i < materials.size(); ++i)
        json["materials"][name_of("material", i)] =
            material_of(read_classic_material(materials[i]));

    json["meshes"] = Json::object();
    json["objects"] = Json::array();
    for (const JsonReader& item : classic["Objects"].array()) {
        Json object;
        const ClassicType type = classic_type(item);
        if (type == ClassicType::sphere) {
            object["sphere"] = {{"center", array_of(item["Position"].vec3())},
                                {"radius", item["Radius"].number_above(0)}};
        } else {
            const std::string name = name_of("mesh", json["meshes"].size());
            if (type == ClassicType::mesh) {
                json["meshes"][name]["file"] = item["Path"].string();
            } else {
                json["meshes"][name]["parallelogram"] = {
                    {"origin", array_of(item["Origin"].vec3())},
                    {"u", array_of(item["U"].vec3())},
                    {"v", array_of(item["V"].vec3())}};
            }
            object["mesh"] = name;
        }
        object["material"] = name_of("material", item["Material"].index(materials.size()));
        json["objects"].push_back(std::move(object));
    }
    return with_short_arrays(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace boxwood
