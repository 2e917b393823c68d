// SPDX-License-Identifier: Apache-2.0
// The camera of the assignment looks along its own -z axis, y up, through a film of the size that
// the field of view spans at the focal length. With a lens it is in focus there and blurs the rest.
#pragma once

#include <cmath>
#include <numbers>

#include "boxwood/core/ray.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// Where on the film and on the lens a ray goes through.
struct CameraSample {
    Vec2d film;                  ///< in pixels from the upper left corner
    Vec2d lens = Vec2d::Zero();  ///< in the unit square; (0, 0) is the pinhole
};

/// What a picture is taken on: its pixels, and half its size where the camera has it.
struct Film {
    int width, height;
    double half_width, half_height;
};

struct Camera {
    bool is_perspective = true;
    Vec3d position = Vec3d::Zero();
    Vec3d right = Vec3d::UnitX();
    Vec3d up = Vec3d::UnitY();
    Vec3d back = Vec3d::UnitZ();    ///< away from what it looks at
    double field_of_view = 0.7854;  ///< the full vertical angle, in radians
    double focal_length = 1;
    double lens_radius = 0;
    /// How far the samples of a pixel spread over it: 0, all through its centre, as classic scenes
    /// demand; 1, all over it, which smooths edges.
    double pixel_spread = 0;

    /// Turns the camera to look from a place to another; up is nearly the given direction.
    void look_at(const Vec3d& from, const Vec3d& to, const Vec3d& nearly_up = Vec3d::UnitY());

    Film film(int width, int height) const;
    /// The ray through a place of this camera's film; its direction has unit length.
    Ray ray(const CameraSample& sample, const Film& film) const;
    /// The same for a film of width by height pixels. For many rays make the film once.
    Ray ray(const CameraSample& sample, int width, int height) const {
        return ray(sample, film(width, height));
    }
};

inline void Camera::look_at(const Vec3d& from, const Vec3d& to, const Vec3d& nearly_up) {
    position = from;
    back = (from - to).normalized();
    right = nearly_up.cross(back).normalized();
    up = back.cross(right);
}

inline Film Camera::film(int width, int height) const {
    const double half_height = focal_length * std::tan(field_of_view / 2);
    return {width, height, half_height * width / height, half_height};
}

inline Ray Camera::ray(const CameraSample& sample, const Film& film) const {
    const double x = -film.half_width + sample.film.x() * 2 * film.half_width / film.width;
    const double y = film.half_height - sample.film.y() * 2 * film.half_height / film.height;

    if (!is_perspective) return {.origin = position + x * right + y * up, .direction = -back};

    // The unit square is spread over the disc of the lens evenly.
    const double radius = lens_radius * std::sqrt(sample.lens.x());
    Vec3d on_lens = Vec3d::Zero();
    if (radius != 0) {
        const double angle = 2 * std::numbers::pi * sample.lens.y();
        on_lens = radius * std::cos(angle) * right + radius * std::sin(angle) * up;
    }
    const Vec3d on_film = x * right + y * up - focal_length * back;
    return {.origin = position + on_lens, .direction = (on_film - on_lens).normalized()};
}

}  // namespace boxwood
