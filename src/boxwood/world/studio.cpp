// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/studio.h"

#include <algorithm>
#include <cmath>

#include "boxwood/core/box.h"

namespace boxwood {

namespace {

constexpr double kFieldOfView = 0.6;
constexpr double kMargin = 1.06;

Vec3d up_of(UpAxis up) { return up == UpAxis::y ? Vec3d::UnitY() : Vec3d::UnitZ(); }

/// From the objects to the camera: to the right, above and in front, where that is +z, or -y when z
/// is up.
Vec3d three_quarter_view(UpAxis up) {
    const Vec3d view = Vec3d(0.62, 0.42, 1).normalized();
    return up == UpAxis::y ? view : Vec3d(view.x(), -view.z(), view.y());
}

/// Calls visit(p) for places that a box, or a picture, of all objects and spheres must hold.
template <class Visit>
void for_each_place(const World& world, const Visit& visit) {
    for (const MeshObject& object : world.objects) {
        for (const Vec3d& p : world.meshes[object.mesh].vertices) {
            const Vec3d place = object.to_world * p;
            if (place.allFinite()) visit(place);
        }
    }
    for (const Sphere& sphere : world.spheres) {
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3d side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            visit(sphere.center + sphere.radius * side);
        }
    }
}

Light directional(const Vec3d& towards, const Color& color) {
    Light light;
    light.kind = LightKind::directional;
    light.direction = -towards.normalized();
    light.color = color;
    return light;
}

}  // namespace

void frame(World& world, UpAxis up) {
    Camera& camera = world.camera;
    camera.field_of_view = kFieldOfView;
    camera.pixel_spread = 1;
    camera.look_at(three_quarter_view(up), Vec3d::Zero(), up_of(up));

    // As the camera sees them the objects span a box. Around its middle, each place tells how far
    // away the camera must be for it to be in the picture.
    const auto seen = [&](const Vec3d& p) {
        return Vec3d(p.dot(camera.right), p.dot(camera.up), p.dot(camera.back));
    };
    Box3d box;
    for_each_place(world, [&](const Vec3d& p) { box.extend(seen(p)); });
    if (box.is_empty()) return;
    const Vec3d center = 0.5 * (box.lo + box.hi);
    const double tall = std::tan(kFieldOfView / 2) / kMargin;
    const double wide = tall * world.picture.width / world.picture.height;
    double distance = 0;
    for_each_place(world, [&](const Vec3d& p) {
        const Vec3d q = seen(p) - center;
        distance =
            std::max({distance, q.z() + std::abs(q.x()) / wide, q.z() + std::abs(q.y()) / tall});
    });
    if (!(distance > 0)) distance = 1;
    camera.position =
        center.x() * camera.right + center.y() * camera.up + (center.z() + distance) * camera.back;
    camera.focal_length = distance;
}

void light_studio(World& world, UpAxis up) {
    const Camera& camera = world.camera;
    const Vec3d above = up_of(up);
    world.background = Color(0.86, 0.88, 0.91);
    world.ambient = Color(0.20, 0.21, 0.23);
    world.lights = {
        directional(camera.back - 0.9 * camera.right + 1.3 * above, Color(0.68, 0.65, 0.60)),
        directional(camera.back + 1.4 * camera.right + 0.3 * above, Color(0.13, 0.15, 0.19)),
        directional(-camera.back + 0.5 * camera.right + 0.8 * above, Color(0.28, 0.29, 0.31))};
}

PictureSettings studio_picture() {
    return {.integrator = IntegratorKind::whitted, .samples = 4, .encoding = ColorEncoding::srgb};
}

Material clay() {
    const Color color(0.74, 0.70, 0.64);
    return {.ambient = color,
            .diffuse = color,
            .specular = Color::Constant(0.06),
            .shininess = 30,
            .name = "clay",
            .is_two_sided = true};
}

}  // namespace boxwood
