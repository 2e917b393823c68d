// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "boxwood/core/box.h"
#include "boxwood/core/float_bits.h"

namespace boxwood {

/// A box whose corners fill SIMD registers. The fourth coordinate is idle.
struct Box4 {
    Eigen::Array4f lo, hi;

    static Box4 empty() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        return {Eigen::Array4f::Constant(kInfinity), Eigen::Array4f::Constant(-kInfinity)};
    }
    Box3f box() const { return {lo.head<3>(), hi.head<3>()}; }

    void extend(const Box4& other) {
        lo = lo.min(other.lo);
        hi = hi.max(other.hi);
    }
    void extend(const Eigen::Array4f& point) {
        lo = lo.min(point);
        hi = hi.max(point);
    }
};

/// The box of a primitive, with its index in the idle coordinates: half of it in each, as numbers
/// of usual size, since some machines are slow with denormal ones.
struct BlockReference {
    Box4 box;

    BlockReference(const Box3f& b, std::uint32_t primitive) {
        box.lo = {b.lo[0], b.lo[1], b.lo[2], float_of(kOne | primitive >> 16)};
        box.hi = {b.hi[0], b.hi[1], b.hi[2], float_of(kOne | (primitive & 0xffff))};
    }
    std::uint32_t primitive() const {
        return bits_of(box.lo[3]) << 16 | (bits_of(box.hi[3]) & 0xffff);
    }
    /// Half the centroid, so that no difference of two of them overflows.
    Eigen::Array4f center() const { return 0.25f * box.lo + 0.25f * box.hi; }

private:
    static constexpr std::uint32_t kOne = 0x3f800000;  ///< 1.0f
};

/// The box and the number of references in each slice of the space of their centers, along each of
/// the three axes.
struct Bins {
    static constexpr int kMost = 32;

    int size;  ///< along an axis
    Box4 box[3][kMost];
    Eigen::Array4i count[kMost];  ///< an axis a lane

    explicit Bins(int bins) : size(bins) {
        for (Box4(&along_axis)[kMost] : box) std::fill_n(along_axis, size, Box4::empty());
        std::fill_n(count, size, Eigen::Array4i::Zero());
    }

    /// Adds a box whose place along each axis is known.
    void add(const Box4& added, const Eigen::Array4i& place) {
        for (int axis = 0; axis < 3; ++axis) {
            box[axis][place[axis]].extend(added);
            ++count[place[axis]][axis];
        }
    }

    void add(const Bins& other) {
        for (int i = 0; i < size; ++i) {
            for (int axis = 0; axis < 3; ++axis) box[axis][i].extend(other.box[axis][i]);
            count[i] += other.count[i];
        }
    }
};

/// Tells the bin of a center: how many bins it is from the lowest one, along each axis. Along a
/// flat axis all are in the first.
class Binning {
public:
    Binning(const Box4& centers, int bins)
        : lo_(centers.lo), last_(Eigen::Array4f::Constant(static_cast<float>(bins - 1))) {
        for (int k = 0; k < 3; ++k) {
            const float scale = static_cast<float>(bins) / (centers.hi[k] - centers.lo[k]);
            if (std::isfinite(scale)) scale_[k] = scale;
        }
    }

    bool is_flat(int axis) const { return scale_[axis] == 0; }
    /// The bin and a fraction.
    Eigen::Array4f place(const Eigen::Array4f& center) const {
        return ((center - lo_) * scale_).min(last_);
    }

private:
    Eigen::Array4f lo_;
    Eigen::Array4f scale_ = Eigen::Array4f::Zero();
    Eigen::Array4f last_;
};

}  // namespace boxwood
