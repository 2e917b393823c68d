// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "boxwood/core/box.h"

namespace boxwood {

/// A box with a fourth, idle coordinate, so that its corners fill SIMD registers.
struct WideBox {
    Eigen::Array4f lo = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array4f hi = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());

    bool is_empty() const { return !(lo.head<3>() <= hi.head<3>()).all(); }
    Box3f box() const { return {lo.head<3>(), hi.head<3>()}; }

    void extend(const WideBox& other) {
        lo = lo.min(other.lo);
        hi = hi.max(other.hi);
    }
    void extend(const Eigen::Array4f& point) {
        lo = lo.min(point);
        hi = hi.max(point);
    }
    friend WideBox merged(WideBox a, const WideBox& b) {
        a.extend(b);
        return a;
    }
    friend WideBox intersection(const WideBox& a, const WideBox& b) {
        WideBox result;
        result.lo = a.lo.max(b.lo);
        result.hi = a.hi.min(b.hi);
        return result;
    }
};

/// The same bits, seen as another type of the same size.
template <class To, class From>
To same_bits_as(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof(To));
    return to;
}

/// A primitive and a box around all of it or a part of it. 32 bytes: the idle coordinate of the
/// lower corner holds the primitive, as the bits of a float between 2^-63 and 2^66, so that sums
/// and differences of it, which nobody looks at, are no subnormal numbers, which are slow.
/// Precondition: at most 2^30 primitives.
class Reference {
public:
    Reference() = default;
    Reference(const Box3f& box, std::uint32_t primitive) {
        box_.lo << box.lo.array(), same_bits_as<float>(primitive + kFirst);
        box_.hi << box.hi.array(), 0;
    }
    /// A part of another.
    Reference(const WideBox& box, const Reference& whole) : box_(box) {
        box_.lo[3] = whole.box_.lo[3];
        box_.hi[3] = 0;
    }

    const WideBox& box() const { return box_; }
    std::uint32_t primitive() const { return same_bits_as<std::uint32_t>(box_.lo[3]) - kFirst; }

private:
    static constexpr std::uint32_t kFirst = 1u << 29;

    WideBox box_;
};

}  // namespace boxwood
