// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <limits>

#include "boxwood/core/box.h"
#include "boxwood/core/vectors.h"

namespace boxwood {

/// A box of floats as two vectors, for passes over many of them: x, y, y once more and z.
struct VectorBox {
    Float4 lo = Float4{} + std::numeric_limits<float>::infinity();
    Float4 hi = Float4{} - std::numeric_limits<float>::infinity();

    VectorBox() = default;
    VectorBox(const Float4& lower, const Float4& upper) : lo(lower), hi(upper) {}
    explicit VectorBox(const Box3f& box) {
        static_assert(sizeof(Box3f) == 24 && offsetof(Box3f, lo) == 0 && offsetof(Box3f, hi) == 12);
        Float4 first, last;
        std::memcpy(&first, &box.lo[0], sizeof first);
        std::memcpy(&last, &box.lo[2], sizeof last);
        lo = __builtin_shufflevector(first, first, 0, 1, 1, 2);
        hi = __builtin_shufflevector(last, last, 1, 2, 2, 3);
    }

    Box3f box() const { return {{lo[0], lo[1], lo[3]}, {hi[0], hi[1], hi[3]}}; }
    Float4 centroid() const { return 0.5f * lo + 0.5f * hi; }

    VectorBox& extend(const VectorBox& other) {
        lo = other.lo < lo ? other.lo : lo;
        hi = other.hi > hi ? other.hi : hi;
        return *this;
    }
    friend VectorBox merged(VectorBox a, const VectorBox& b) { return a.extend(b); }
};

inline bool is_finite(const Float4& x) { return all_of(x - x == 0); }

}  // namespace boxwood
