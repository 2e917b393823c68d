// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace boxwood {

/// A Ray in float, 32 plain bytes as batches of rays are kept: the points origin + t * direction
/// with t_min <= t <= t_max. Distances t are in multiples of the direction's length. A ray hits
/// nothing when a coordinate is NaN, the direction's largest is outside [2^-40, 2^40], the origin's
/// beyond 2^57, or not t_min <= t_max.
struct Rayf {
    float origin[3] = {0, 0, 0};
    float t_min = 0;
    float direction[3] = {0, 0, -1};
    float t_max = std::numeric_limits<float>::infinity();
};

/// Where a ray meets a triangle (a, b, c): at origin + t * direction, or (1 - u - v) a + u b + v c.
/// A ray that hits nothing has t = infinity and triangle = kNone.
struct Hitf {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    float t = std::numeric_limits<float>::infinity();
    float u = 0, v = 0;
    std::uint32_t triangle = kNone;
    float normal[3] = {0, 0, 0};  ///< (b - a) x (c - a), infinite or 0 beyond floats
    std::uint32_t instance = 0;   ///< of a scene

    bool is_hit() const { return triangle != kNone; }
};

static_assert(sizeof(Rayf) == 32 && sizeof(Hitf) == 32);

}  // namespace boxwood
