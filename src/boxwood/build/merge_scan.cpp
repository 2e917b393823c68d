// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/merge_scan.h"

#include <algorithm>
#include <limits>

#include "boxwood/build/unit_scale.h"

namespace boxwood {

MergeScan::MergeScan(std::span<const Box3f> boxes, MergeCost cost)
    : lo_(boxes.size(), 3),
      hi_(boxes.size(), 3),
      volume_(boxes.size()),
      costs_(boxes.size()),
      cost_(cost) {
    const float scale = unit_scale(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        // Boxes that nothing hits have no place; any will do.
        const Box3f box = boxes[i].is_empty() ? Box3f{Vec3f::Zero(), Vec3f::Zero()} : boxes[i];
        lo_.row(i) = scale * box.lo;
        hi_.row(i) = scale * box.hi;
    }
    // Multiplied in the order of the union's volume below, so that a box adds nothing to itself.
    const Eigen::ArrayX3f extent = hi_ - lo_;
    volume_ = extent.col(0) * extent.col(1) * extent.col(2);
}

void MergeScan::compute_costs(std::uint32_t i, std::uint32_t begin, std::uint32_t end) {
    const auto lo = [&](int k) { return lo_.col(k).segment(begin, end - begin); };
    const auto hi = [&](int k) { return hi_.col(k).segment(begin, end - begin); };
    const auto extent = [&](int k) { return hi(k).max(hi_(i, k)) - lo(k).min(lo_(i, k)); };
    const auto between_centres = [&](int k) {
        return 0.5f * (lo(k) + hi(k)) - 0.5f * (lo_(i, k) + hi_(i, k));
    };

    auto costs = costs_.segment(begin, end - begin);
    switch (cost_) {
        case MergeCost::centroid_distance:  // squared, which has the same order
            costs = between_centres(0).square() + between_centres(1).square() +
                    between_centres(2).square();
            break;
        case MergeCost::volume_increase:
            costs = extent(0) * extent(1) * extent(2) -
                    (volume_.segment(begin, end - begin) + volume_[i]);
            break;
        case MergeCost::surface_area:  // halved
            costs = extent(0) * extent(1) + extent(1) * extent(2) + extent(2) * extent(0);
            break;
    }
}

std::pair<std::uint32_t, float> MergeScan::cheapest(std::uint32_t begin, std::uint32_t end) const {
    if (begin >= end) return {end, std::numeric_limits<float>::infinity()};
    const float least = costs_.segment(begin, end - begin).minCoeff();
    const float* found = std::find(costs_.data() + begin, costs_.data() + end, least);
    return {static_cast<std::uint32_t>(found - costs_.data()), least};
}

void MergeScan::merge(std::uint32_t i, std::uint32_t j) {
    constexpr float kFarAway = 1e9f;
    lo_.row(i) = lo_.row(i).min(lo_.row(j));
    hi_.row(i) = hi_.row(i).max(hi_.row(j));
    const Eigen::Array<float, 1, 3> extent = hi_.row(i) - lo_.row(i);
    volume_[i] = extent[0] * extent[1] * extent[2];
    lo_.row(j) = kFarAway;
    hi_.row(j) = kFarAway;
    volume_[j] = 0;
}

void MergeScan::move(std::uint32_t from, std::uint32_t to) {
    lo_.row(to) = lo_.row(from);
    hi_.row(to) = hi_.row(from);
    volume_[to] = volume_[from];
}

}  // namespace boxwood
