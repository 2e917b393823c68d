// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "boxwood/tree/tree.h"

namespace boxwood {

struct MedianOptions {
    /// What the primitives are sorted by, one a box; the centres of the boxes when left empty.
    std::span<const Vec3d> centroids = {};
};

/// The textbook's top-down builder: half of the primitives left, half right, one a leaf.
/// The tree has depth ceil(log2 n). O(n log n) time, all cores, the same tree for any number of
/// them. Throws InvalidInput when there are centroids, but not one a box.
Tree build_median(std::span<const Box3f> boxes, const MedianOptions& options = {});

}  // namespace boxwood
