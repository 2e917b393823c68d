// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/classic_parts.h"

#include <numbers>

namespace boxwood {

void check_classic_keys(const JsonReader& scene) {
    scene.expect_keys({"Scene", "Camera", "Materials", "Lights", "Objects"});
    scene["Scene"].expect_keys({"Background", "Ambient"});
}

Camera read_classic_camera(const JsonReader& json) {
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

Material read_classic_material(const JsonReader& json) {
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

Light read_classic_light(const JsonReader& json) {
    json.expect_keys({"Position", "Color"});
    return {.position = json["Position"].vec3(), .color = json["Color"].vec3()};
}

ClassicType classic_type(const JsonReader& object) {
    const std::string type = object["Type"].string();
    if (type == "Sphere") {
        object.expect_keys({"Type", "Material", "Position", "Radius"});
        return ClassicType::sphere;
    }
    if (type == "Parallelogram") {
        object.expect_keys({"Type", "Material", "Origin", "U", "V"});
        return ClassicType::parallelogram;
    }
    if (type == "Mesh") {
        object.expect_keys({"Type", "Material", "Path"});
        return ClassicType::mesh;
    }
    object["Type"].fail("\"Sphere\", \"Parallelogram\" or \"Mesh\"");
}

}  // namespace boxwood
