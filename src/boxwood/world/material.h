// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "boxwood/core/vec.h"
#include "boxwood/world/color.h"

namespace boxwood {

/// A texture of the world as a material uses it: where a place with texture coordinates (u, v) is
/// in the picture, as (x, y) from its upper left corner, in widths and heights.
struct TextureUse {
    std::size_t texture = 0;
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();  ///< acts on (u, 1 - v)
    Vec2d offset = Vec2d::Zero();

    Vec2d place(const Vec2d& uv) const { return linear * Vec2d(uv.x(), 1 - uv.y()) + offset; }
};

/// How a surface answers light, as in the assignment: Phong's terms plus mirror and refraction. The
/// color of a place, from texture and vertices, multiplies ambient and diffuse.
struct Material {
    Color ambient = Color::Zero();
    Color diffuse = Color::Zero();
    Color specular = Color::Zero();
    Color mirror = Color::Zero();
    Color refraction = Color::Zero();
    double refraction_index = 1;
    double shininess = 0;

    std::string name = {};
    Color emission = Color::Zero();
    std::optional<TextureUse> color_texture = {};
    std::optional<TextureUse> emission_texture = {};  ///< multiplies emission
    bool uses_vertex_colors = true;
    /// Lit alike on both sides; else what is seen from behind is as dark as Phong's terms make it.
    bool is_two_sided = false;
    /// Not seen at all from behind.
    bool culls_back_faces = false;
    /// Where it is below 1, what lies behind shines through.
    double opacity = 1;
    /// Whether the texture and the vertices' colors have a say in the opacity.
    bool blends = false;
    /// Places of less opacity aren't there at all, others are opaque.
    std::optional<double> opacity_cutoff = {};
};

}  // namespace boxwood
