// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/core/error.h"

namespace boxwood {

/// What every batch of rays asks for first. Throws InvalidInput when the sizes differ.
inline void check_hit_places(std::size_t rays, std::size_t hits) {
    if (rays != hits)
        throw InvalidInput("closest_hits, any_hits: expected as many places for hits as rays");
}
inline void check_count_places(std::size_t rays, std::size_t counts) {
    if (rays != counts)
        throw InvalidInput("count_hits: expected as many places for counts as rays");
}
inline void check_hit_rows(std::size_t rays, std::size_t k, std::size_t hits) {
    // Not rays * k, which may overflow.
    if (k == 0 ? hits != 0 : hits % k != 0 || hits / k != rays)
        throw InvalidInput("first_k_hits: expected k places for hits for each ray");
}

}  // namespace boxwood
