// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/core/vec.h"
#include "boxwood/world/color.h"

namespace boxwood {

enum class LightKind {
    point,        ///< what arrives at distance d is color / d^2
    spot,         ///< the same within a cone
    directional,  ///< what arrives is color everywhere, from infinitely far
};

struct Light {
    Vec3d position = Vec3d::Zero();
    Color color = Color::Zero();
    LightKind kind = LightKind::point;
    Vec3d direction = -Vec3d::UnitZ();  ///< in which a spot or a directional light shines; unit
    /// Cosines of the angles to that direction up to which a spot is whole, and gone.
    double cos_inner = 1, cos_outer = 0.7071067811865476;
};

/// What a light means to a point.
struct LightAt {
    Vec3d towards;    ///< the light's direction from the point, of unit length
    double distance;  ///< infinite for a directional light
    double fall_off;  ///< what arrives is its color divided by this
};

inline LightAt light_at(const Light& light, const Vec3d& point) {
    if (light.kind == LightKind::directional)
        return {-light.direction, std::numeric_limits<double>::infinity(), 1};
    const Vec3d towards = light.position - point;
    LightAt result = {towards.normalized(), towards.norm(), towards.squaredNorm()};
    if (light.kind == LightKind::spot) {
        const double cosine = -result.towards.dot(light.direction);
        const double width = std::max(light.cos_inner - light.cos_outer, 1e-9);
        const double inside = std::clamp((cosine - light.cos_outer) / width, 0.0, 1.0);
        result.fall_off /= inside * inside;  // infinite outside
    }
    return result;
}

}  // namespace boxwood
