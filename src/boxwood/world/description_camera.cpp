// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/description_camera.h"

#include <cmath>
#include <numbers>

#include "boxwood/world/degrees.h"

namespace boxwood {

namespace {

Vec3d unit(const JsonReader& json) {
    const Vec3d direction = json.vec3();
    Vec3d result = direction.stableNormalized();
    if (direction.isZero(0) || !result.allFinite()) json.fail("a direction that isn't zero");
    return result;
}

/// Turns the camera the way that "to" or "direction" and "up" say.
void turn(const JsonReader& json, Camera& camera) {
    const auto to = json.find("to");
    const auto direction = json.find("direction");
    if (to.has_value() == direction.has_value()) json.fail("either \"to\" or \"direction\"");
    if (to && to->vec3() == camera.position) to->fail("another place than \"from\"");
    const Vec3d back = direction ? Vec3d(-unit(*direction))
                                 : Vec3d((camera.position - to->vec3()).stableNormalized());
    const auto up = json.find("up");
    const Vec3d nearly_up = up ? unit(*up) : Vec3d(Vec3d::UnitY());
    const Vec3d right = nearly_up.cross(back);
    if (!back.allFinite() || !(right.norm() > 1e-9)) {
        if (up) up->fail("a direction across the one that the camera looks in");
        json.fail("\"up\", as the camera looks along the y axis");
    }
    camera.back = back;
    camera.right = right.normalized();
    camera.up = back.cross(camera.right);
}

}  // namespace

Camera read_description_camera(const JsonReader& json) {
    const auto type = json.find("type");
    Camera camera;
    camera.is_perspective = !type || type->string() == "perspective";
    camera.pixel_spread = 1;
    if (camera.is_perspective) {
        json.expect_keys({"from"}, {"type", "to", "direction", "up", "field_of_view",
                                    "focus_distance", "lens_radius", "pixel_spread"});
    } else if (type->string() == "orthographic") {
        json.expect_keys({"from", "height"}, {"type", "to", "direction", "up", "pixel_spread"});
    } else {
        type->fail("\"perspective\" or \"orthographic\"");
    }
    camera.position = json["from"].vec3();
    turn(json, camera);
    if (const auto spread = json.find("pixel_spread"))
        camera.pixel_spread = spread->number_within(0, 1);
    if (!camera.is_perspective) {
        camera.field_of_view = 2 * std::atan(json["height"].number_above(0) / 2);
        return camera;
    }
    if (const auto angle = json.find("field_of_view")) {
        if (!(angle->number_above(0) < 180)) angle->fail("an angle below 180 degrees");
        camera.field_of_view = radians(angle->number());
    }
    if (const auto distance = json.find("focus_distance"))
        camera.focal_length = distance->number_above(0);
    if (const auto radius = json.find("lens_radius"))
        camera.lens_radius = radius->number_at_least(0);
    return camera;
}

Light read_description_light(const JsonReader& json) {
    Light light;
    const JsonReader type = json["type"];
    light.color = json["color"].vec3();
    if (type.string() == "point") {
        json.expect_keys({"type", "position", "color"});
        light.position = json["position"].vec3();
    } else if (type.string() == "directional") {
        json.expect_keys({"type", "direction", "color"});
        light.kind = LightKind::directional;
        light.direction = unit(json["direction"]);
    } else if (type.string() == "spot") {
        json.expect_keys({"type", "position", "direction", "color"},
                         {"inner_angle", "outer_angle"});
        light.kind = LightKind::spot;
        light.position = json["position"].vec3();
        light.direction = unit(json["direction"]);
        const auto outer = json.find("outer_angle");
        const auto inner = json.find("inner_angle");
        const double outer_angle = outer ? outer->number_within(0, 90) : 45;
        light.cos_outer = std::cos(radians(outer_angle));
        light.cos_inner = inner ? std::cos(radians(inner->number_within(0, outer_angle))) : 1;
    } else {
        type.fail("\"point\", \"directional\" or \"spot\", the lights that are rendered");
    }
    return light;
}

}  // namespace boxwood
