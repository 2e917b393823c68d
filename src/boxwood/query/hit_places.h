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

}  // namespace boxwood
