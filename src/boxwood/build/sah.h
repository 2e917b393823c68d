// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "boxwood/build/reference.h"

namespace boxwood {

/// The surface area heuristic over references, in units in which areas neither overflow nor vanish.
class Sah {
public:
    /// With the scale of unit_scale(); a leaf tests 2^block_shift primitives at a time.
    Sah(float scale, int block_shift)
        : scale_(scale, scale, scale, 0), half_scale_(0.5f * scale_), block_shift_(block_shift) {}

    float half_area(const WideBox& box) const {
        const Eigen::Array4f e = (scale_ * box.hi - scale_ * box.lo).max(0.0f);
        return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
    }
    Eigen::Array4f centre(const WideBox& box) const {
        return half_scale_ * box.lo + half_scale_ * box.hi;
    }
    float blocks(std::uint32_t count) const {
        return static_cast<float>((count + (1u << block_shift_) - 1) >> block_shift_);
    }
    /// Of the tests of so many primitives when a ray hits the box.
    float cost(const WideBox& box, std::uint32_t count) const {
        return half_area(box) * blocks(count);
    }

private:
    Eigen::Array4f scale_, half_scale_;  ///< none in the idle coordinate
    int block_shift_;
};

/// Equally wide bins along each axis of a box.
class Grid {
public:
    Grid(const WideBox& bounds, int bins) : lo_(bounds.lo) {
        const Eigen::Array4f extent = bounds.hi - bounds.lo;
        for (int k = 0; k < 3; ++k) {
            // A little less than there are bins, so that the upper end is in the last one.
            const float scale = 0.99999f * static_cast<float>(bins) / extent[k];
            if (!std::isfinite(scale) || scale == 0) {
                lo_[k] = 0;  // so that no difference overflows
                continue;
            }
            scale_[k] = scale;
            width_[k] = 1 / scale;
        }
    }

    /// Along a flat axis there is only one bin.
    bool is_flat(int axis) const { return scale_[axis] == 0; }
    /// The lower face of a bin.
    float face(int axis, int bin) const {
        return lo_[axis] + static_cast<float>(bin) * width_[axis];
    }
    Eigen::Array4i bins_of(const Eigen::Array4f& point) const {
        return ((point - lo_) * scale_).cast<int>();
    }
    /// The bins of the upper ends of intervals that begin in the bins `first`. What ends exactly on
    /// a face doesn't reach the bin above it.
    Eigen::Array4i last_bins_of(const Eigen::Array4f& point, const Eigen::Array4i& first) const {
        const Eigen::Array4f place = (point - lo_) * scale_;
        const Eigen::Array4i bin = place.cast<int>();
        return (bin - (bin.cast<float>() == place).cast<int>()).max(first);
    }

private:
    Eigen::Array4f lo_;
    Eigen::Array4f scale_ = Eigen::Array4f::Zero();
    Eigen::Array4f width_ = Eigen::Array4f::Zero();
};

}  // namespace boxwood
