// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxwood/core/ray.h"

namespace boxwood {

/// Hits of many rays, one list after another: those of the i-th ray are from offsets[i] to
/// offsets[i + 1] in the other arrays.
struct HitLists {
    std::vector<std::size_t> offsets = {0};  ///< one more than rays
    std::vector<double> t, u, v;
    std::vector<std::uint32_t> triangle;
    std::vector<std::uint32_t> instance;  ///< all 0 where there is one

    std::size_t size() const { return offsets.size() - 1; }
    std::size_t count(std::size_t ray) const { return offsets[ray + 1] - offsets[ray]; }
    /// The n-th hit of a ray.
    Hit hit(std::size_t ray, std::size_t n) const {
        const std::size_t i = offsets[ray] + n;
        return {.t = t[i], .u = u[i], .v = v[i], .triangle = triangle[i], .instance = instance[i]};
    }
};

}  // namespace boxwood
