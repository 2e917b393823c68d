// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/core/random.h"
#include "boxwood/core/vec.h"

namespace boxwood {

/// A run of random numbers, the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}

    double number() { return uniform(seed_, count_++, 0); }
    double number(double lo, double hi) { return lo + (hi - lo) * number(); }
    std::size_t index(std::size_t count) {
        return static_cast<std::size_t>(number() * static_cast<double>(count));
    }
    Vec3d point(double lo, double hi) {
        const double x = number(lo, hi), y = number(lo, hi), z = number(lo, hi);
        return {x, y, z};
    }
    /// Of unit length.
    Vec3d direction() {
        for (;;) {
            const Vec3d p = point(-1, 1);
            if (p.squaredNorm() > 0.01 && p.squaredNorm() <= 1) return p.normalized();
        }
    }

private:
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace boxwood
