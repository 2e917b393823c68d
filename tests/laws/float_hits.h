// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <optional>

#include "boxwood/core/ray.h"
#include "boxwood/query/rayf.h"

namespace boxwood {

inline Rayf in_float(const Ray& ray) {
    Rayf result;
    for (int k = 0; k < 3; ++k) {
        result.origin[k] = static_cast<float>(ray.origin[k]);
        result.direction[k] = static_cast<float>(ray.direction[k]);
    }
    result.t_min = static_cast<float>(ray.t_min);
    result.t_max = static_cast<float>(ray.t_max);
    return result;
}

inline bool have_same_bits(const std::optional<Hitf>& a, const std::optional<Hitf>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return std::memcmp(&*a, &*b, sizeof(Hitf)) == 0;
}

}  // namespace boxwood
