// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "boxwood/core/ray.h"

namespace boxwood {

/// Rays that leave the points where others hit, with the places of those.
struct OnwardRays {
    std::vector<Ray> rays;
    std::vector<std::size_t> places;

    void add(const Ray& ray, std::size_t place) {
        rays.push_back(ray);
        places.push_back(place);
    }
    bool is_empty() const { return rays.empty(); }
};

}  // namespace boxwood
