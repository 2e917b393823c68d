// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

/// What merging two nodes costs.
enum class MergeCost {
    centroid_distance,  ///< the distance between the centres of the two boxes
    volume_increase,    ///< the volume of the union less the volumes of the two
    surface_area,       ///< the surface area of the union
};

struct AgglomerativeOptions {
    MergeCost cost = MergeCost::surface_area;
};

/// The textbook's bottom-up builder: merge the two nodes of least cost until one is left; one
/// primitive a leaf. Costs are computed in float. Among equally cheap pairs the one with the lowest
/// primitives is merged first: a node stands for the lowest primitive below it, and pairs are
/// compared by their lower node, then by their higher one. The tree may be as deep as it has
/// primitives. O(n^2) time on real meshes, O(n^3) on contrived ones; O(n) memory, one core.
Tree build_agglomerative(std::span<const Box3f> boxes, const AgglomerativeOptions& options = {});

/// Above this many primitives the quadratic time is long enough to warn of.
constexpr std::size_t kManyToAgglomerate = 200'000;

}  // namespace boxwood
