// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "boxwood/build/reference.h"
#include "boxwood/build/sah.h"
#include "boxwood/mesh/triangle_mesh.h"

namespace boxwood {

/// A cut through space, at the lower face of a bin of a grid.
struct SpatialSplit {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;  ///< -1: there is none
    int bin = 0;    ///< the first bin of the right side
};

constexpr int kSpatialBins = 16;

/// The cheapest cut along the inner faces of a grid of kSpatialBins that is cheaper than `limit`
/// and splits at most `room` of the references. O(references * bins), and mostly O(references).
SpatialSplit best_spatial_split(MeshView mesh, std::span<const Reference> references,
                                const Sah& sah, const Grid& grid, std::uint32_t room, float limit);

}  // namespace boxwood
