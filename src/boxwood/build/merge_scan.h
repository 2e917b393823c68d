// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>

#include "boxwood/build/agglomerative.h"
#include "boxwood/core/box.h"

namespace boxwood {

/// The boxes of the nodes that are still to be merged, side by side coordinate by coordinate, so
/// that the costs of merging one of them with all others are a SIMD scan.
class MergeScan {
public:
    MergeScan(std::span<const Box3f> boxes, MergeCost cost);

    /// Computes the cost of merging node i with each node of [begin, end).
    void compute_costs(std::uint32_t i, std::uint32_t begin, std::uint32_t end);
    float cost(std::uint32_t node) const { return costs_[node]; }
    const float* costs() const { return costs_.data(); }

    /// The lowest of the cheapest nodes in [begin, end), and its cost; infinite when there is none.
    std::pair<std::uint32_t, float> cheapest(std::uint32_t begin, std::uint32_t end) const;

    /// Node i becomes the union of both; node j becomes a box so far away that it is never
    /// cheapest.
    void merge(std::uint32_t i, std::uint32_t j);
    /// Node to becomes what node from was.
    void move(std::uint32_t from, std::uint32_t to);

private:
    Eigen::ArrayX3f lo_, hi_;
    Eigen::ArrayXf volume_;
    Eigen::ArrayXf costs_;
    MergeCost cost_;
};

}  // namespace boxwood
