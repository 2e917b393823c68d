// SPDX-License-Identifier: Apache-2.0
// Rays and hits whose parts stand in arrays of their own, as numpy and Eigen keep them. Batches
// read and write these where they are.
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/core/simd.h"
#include "boxwood/core/vectors.h"
#include "boxwood/query/rayf.h"

namespace boxwood {

/// One or three floats for each ray, the next ray's so many floats on; 0 gives all rays the same.
struct FloatColumn {
    const float* first = nullptr;
    std::ptrdiff_t step = 0;

    BOXWOOD_KERNEL const float* operator[](std::size_t i) const {
        return first + static_cast<std::ptrdiff_t>(i) * step;
    }
};

/// So many rays, each as in Rayf. Precondition of all that takes them: no column is null.
struct RayColumns {
    std::size_t count = 0;
    FloatColumn origin, direction;  ///< three floats each
    FloatColumn t_min, t_max;

    BOXWOOD_KERNEL Rayf operator[](std::size_t i) const {
        const float *o = origin[i], *d = direction[i];
        // Stored as the vectors that they are read as: else readers wait until memory has them.
        const Float4 origin_and_t_min = {o[0], o[1], o[2], *t_min[i]},
                     direction_and_t_max = {d[0], d[1], d[2], *t_max[i]};
        Rayf ray = {};
        static_assert(offsetof(Rayf, t_min) == 12 && offsetof(Rayf, t_max) == 28);
        __builtin_memcpy(ray.origin, &origin_and_t_min, sizeof origin_and_t_min);
        __builtin_memcpy(ray.direction, &direction_and_t_max, sizeof direction_and_t_max);
        return ray;
    }

    RayColumns part(std::size_t begin, std::size_t size) const {
        return {size,
                {origin[begin], origin.step},
                {direction[begin], direction.step},
                {t_min[begin], t_min.step},
                {t_max[begin], t_max.step}};
    }
};

/// So many places for hits, each as in Hitf but for two things: the normal is of unit length, or 0
/// where there is none; the instance of a ray that hits nothing is Hitf::kNone. Precondition of all
/// that takes them: no column is null, and none overlaps another or the rays.
struct HitColumns {
    std::size_t count = 0;
    float* t = nullptr;
    std::uint32_t *triangle = nullptr, *instance = nullptr;
    float* uv = nullptr;      ///< two for each hit
    float* normal = nullptr;  ///< three

    HitColumns part(std::size_t begin, std::size_t size) const {
        return {size,           t + begin,         triangle + begin, instance + begin,
                uv + 2 * begin, normal + 3 * begin};
    }
};

}  // namespace boxwood
