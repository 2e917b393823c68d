// SPDX-License-Identifier: Apache-2.0
// From double to float such that what was inside stays inside.
#pragma once

#include <cstdint>
#include <cstring>

#include "boxwood/core/box.h"
#include "boxwood/core/float_bits.h"
#include "boxwood/core/vec.h"
#include "boxwood/core/vector_box.h"
#include "boxwood/core/vectors.h"

namespace boxwood {

/// The largest float that isn't above x, and the smallest that isn't below. Rounding to nearest
/// keeps the sign, that of zero included, so one step of the bits from there is one towards or away
/// from zero. No branches: nobody could predict where rounding goes.
inline float rounded_down(double x) {
    const auto nearest = static_cast<float>(x);
    const auto bits = static_cast<std::int32_t>(bits_of(nearest));
    const std::int32_t one_up = bits >> 31 | 1;
    return float_of(static_cast<std::uint32_t>(bits - (one_up & -std::int32_t{nearest > x})));
}
inline float rounded_up(double x) {
    const auto nearest = static_cast<float>(x);
    const auto bits = static_cast<std::int32_t>(bits_of(nearest));
    const std::int32_t one_up = bits >> 31 | 1;
    return float_of(static_cast<std::uint32_t>(bits + (one_up & -std::int32_t{nearest < x})));
}

/// A point as two vectors, (x, y) and (y, z), since a vector of four would reach beyond it.
struct Pairs {
    Double2 xy, yz;

    explicit Pairs(const Vec3d& p) {
        std::memcpy(&xy, &p[0], sizeof xy);
        std::memcpy(&yz, &p[1], sizeof yz);
    }
    Pairs(const Double2& first, const Double2& last) : xy(first), yz(last) {}

    Pairs min(const Pairs& b) const { return {xy < b.xy ? xy : b.xy, yz < b.yz ? yz : b.yz}; }
    Pairs max(const Pairs& b) const { return {xy > b.xy ? xy : b.xy, yz > b.yz ? yz : b.yz}; }
};

/// Its x, y, y and z, each rounded down (step is -1) or up (1) to float.
inline Float4 rounded(const Pairs& p, int step) {
    using Float2 = float __attribute__((vector_size(8)));
    const Float2 xy = __builtin_convertvector(p.xy, Float2);
    const Float2 yz = __builtin_convertvector(p.yz, Float2);
    const Double2 near_xy = __builtin_convertvector(xy, Double2);
    const Double2 near_yz = __builtin_convertvector(yz, Double2);
    // Of each mask of 64 bits 32 will do.
    const auto on_wrong_side = [step](const Double2& near, const Double2& exact) {
        return reinterpret_cast<Int4>(step < 0 ? near > exact : near < exact);
    };
    const Int4 is_wrong = __builtin_shufflevector(on_wrong_side(near_xy, p.xy),
                                                  on_wrong_side(near_yz, p.yz), 0, 2, 4, 6);
    const Int4 bits = reinterpret_cast<Int4>(__builtin_shufflevector(xy, yz, 0, 1, 2, 3));
    return reinterpret_cast<Float4>(bits + ((bits >> 31 | 1) * step & is_wrong));
}

/// The smallest float box that contains the corners lo and hi. Empty, so that no query ever visits
/// it, when a coordinate is NaN, infinite or beyond the range of float, or must_be_finite isn't.
inline VectorBox rounded_outward(const Pairs& lo, const Pairs& hi, const Pairs& must_be_finite) {
    const Float4 down = rounded(lo, -1), up = rounded(hi, 1);
    // Zero, or NaN where something isn't finite.
    const Float4 of_box = 0 * down + 0 * up;
    const Double2 of_rest = 0 * must_be_finite.xy + 0 * must_be_finite.yz;
    if (!(double{of_box[0] + of_box[1] + of_box[3]} + (of_rest[0] + of_rest[1]) == 0)) return {};
    return {down, up};
}

inline Box3f rounded_outward(const Box3d& box) {
    const Pairs lo(box.lo), hi(box.hi);
    return rounded_outward(lo, hi, lo).box();
}

}  // namespace boxwood
