// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxwood {
namespace {

/// The formulas of the classic scene's page, letter by letter.
Ray classic_ray(const Camera& camera, int i, int j, int width, int height) {
    const double scale_y = camera.focal_length * std::tan(camera.field_of_view / 2);
    const double scale_x = scale_y * width / height;
    const Vec3d shift(-scale_x + (i + 0.5) * 2 * scale_x / width,
                      scale_y - (j + 0.5) * 2 * scale_y / height, -camera.focal_length);
    if (camera.is_perspective) return {.origin = camera.position, .direction = shift.normalized()};
    return {.origin = camera.position + Vec3d(shift.x(), shift.y(), 0), .direction = {0, 0, -1}};
}

Camera some_camera() {
    Camera camera;
    camera.position = {0.1, 0.2, 2};
    camera.field_of_view = 0.7854;
    camera.focal_length = 2;
    return camera;
}

TEST(Camera, rays_through_pixel_centres_are_those_of_the_formulas) {
    Camera camera = some_camera();
    for (const bool is_perspective : {true, false}) {
        camera.is_perspective = is_perspective;
        for (const auto& [i, j] :
             {std::pair(0, 0), {639, 0}, {0, 479}, {639, 479}, {320, 240}, {7, 301}}) {
            const Ray expected = classic_ray(camera, i, j, 640, 480);
            const Ray found = camera.ray({.film = {i + 0.5, j + 0.5}}, 640, 480);
            EXPECT_TRUE(found.origin.isApprox(expected.origin, 1e-15)) << i << " " << j;
            EXPECT_TRUE(found.direction.isApprox(expected.direction, 1e-15)) << i << " " << j;
            EXPECT_EQ(found.t_min, 0);
        }
    }
}

TEST(Camera, first_pixel_is_up_and_left) {
    const Ray ray = some_camera().ray({.film = {0.5, 0.5}}, 640, 480);
    EXPECT_LT(ray.direction.x(), 0);
    EXPECT_GT(ray.direction.y(), 0);
    EXPECT_LT(ray.direction.z(), 0);
}

TEST(Camera, pixels_are_square_at_any_aspect) {
    const Camera camera = some_camera();
    for (const auto& [w, h] : {std::pair(640, 480), {100, 300}, {1, 1}, {999, 10}}) {
        const int width = w, height = h;
        const auto on_film = [&](double x, double y) -> Vec3d {
            const Ray ray = camera.ray({.film = {x, y}}, width, height);
            return ray.direction / -ray.direction.z();
        };
        const double dx = on_film(1, 0).x() - on_film(0, 0).x();
        const double dy = on_film(0, 0).y() - on_film(0, 1).y();
        EXPECT_NEAR(dx / dy, 1, 1e-9) << width << "x" << height;
        EXPECT_NEAR(on_film(0, 0).y(), std::tan(camera.field_of_view / 2), 1e-12);
    }
}

TEST(Camera, lens_rays_start_on_the_disc_and_meet_at_the_focal_plane) {
    Camera camera = some_camera();
    camera.lens_radius = 0.08;
    const Ray pinhole = camera.ray({.film = {100, 50}}, 640, 480);
    const Vec3d focus = pinhole.at(camera.focal_length / -pinhole.direction.z());
    for (double s = 0.05; s < 1; s += 0.1) {
        for (double t = 0; t < 1; t += 0.1) {
            const Ray ray = camera.ray({.film = {100, 50}, .lens = {s, t}}, 640, 480);
            const Vec3d on_lens = ray.origin - camera.position;
            EXPECT_NEAR(on_lens.norm(), 0.08 * std::sqrt(s), 1e-12);
            EXPECT_NEAR(on_lens.z(), 0, 1e-12);
            EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
            const Vec3d there = ray.at((focus - ray.origin).norm());
            EXPECT_NEAR((there - focus).norm(), 0, 1e-12);
        }
    }
}

TEST(Camera, look_at_turns_it_to_a_right_handed_frame) {
    Camera camera;
    camera.look_at({3, 2, 5}, {0, 1, -1});
    const Ray middle = camera.ray({.film = {50, 50}}, 100, 100);
    EXPECT_TRUE(middle.direction.isApprox((Vec3d(0, 1, -1) - Vec3d(3, 2, 5)).normalized(), 1e-12));
    EXPECT_TRUE(camera.right.cross(camera.up).isApprox(camera.back, 1e-12));
    EXPECT_NEAR(camera.right.y(), 0, 1e-12);
    EXPECT_GT(camera.up.y(), 0);
}

}  // namespace
}  // namespace boxwood
