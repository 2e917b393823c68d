// SPDX-License-Identifier: Apache-2.0
// Four lanes in plain C++, for any machine, and the reference for the others. See core/simd.h.
#pragma once

#include <cmath>
#include <cstring>

#include "boxwood/core/simd.h"
#include "boxwood/core/simd_fused.h"

namespace boxwood {

struct Scalar {
    static constexpr int kWidth = 4;
    static constexpr bool kFastFused = false;

    template <class T>
    struct alignas(16) Lanes {
        T lane[kWidth];

        friend Lanes operator+(const Lanes& a, const Lanes& b) {
            return map([&](int i) { return a.lane[i] + b.lane[i]; });
        }
        friend Lanes operator-(const Lanes& a, const Lanes& b) {
            return map([&](int i) { return a.lane[i] - b.lane[i]; });
        }
        friend Lanes operator-(const Lanes& a) {
            return map([&](int i) { return -a.lane[i]; });
        }
        friend Lanes operator*(const Lanes& a, const Lanes& b) {
            return map([&](int i) { return a.lane[i] * b.lane[i]; });
        }
        friend Lanes operator/(const Lanes& a, const Lanes& b) {
            return map([&](int i) { return a.lane[i] / b.lane[i]; });
        }

        template <class F>
        static Lanes map(const F& f) {
            Lanes result;
            for (int i = 0; i < kWidth; ++i) result.lane[i] = f(i);
            return result;
        }
    };
    using Float = Lanes<float>;
    using Int = Lanes<std::uint32_t>;
    using Quad = Scalar;

    static Float load(const float* p) {
        return Float::map([&](int i) { return p[i]; });
    }
    static Int load(const std::uint32_t* p) {
        return Int::map([&](int i) { return p[i]; });
    }
    static Float load_unaligned(const float* p) { return load(p); }
    static Int load_unaligned(const std::uint32_t* p) { return load(p); }
    static void store(float* p, const Float& x) { store_lanes(p, x); }
    static void store_unaligned(float* p, const Float& x) { store_lanes(p, x); }
    static void store_unaligned(std::uint32_t* p, const Int& x) { store_lanes(p, x); }
    static Float broadcast(float x) {
        return Float::map([&](int) { return x; });
    }
    static Int broadcast_integer(std::uint32_t x) {
        return Int::map([&](int) { return x; });
    }

    static Float min(const Float& a, const Float& b) {
        return Float::map([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
    }
    static Float max(const Float& a, const Float& b) {
        return Float::map([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
    }
    static Float abs(const Float& x) {
        return Float::map([&](int i) { return std::fabs(x.lane[i]); });
    }
    static Float copy_sign(const Float& size, const Float& sign) {
        return Float::map([&](int i) { return std::copysign(size.lane[i], sign.lane[i]); });
    }
    /// In every lane.
    static Float largest_of_three(const Float& x) {
        const float xy = x.lane[0] > x.lane[1] ? x.lane[0] : x.lane[1];
        return broadcast(xy > x.lane[2] ? xy : x.lane[2]);
    }
    static unsigned signs(const Float& x) {
        return bits([&](int i) { return std::signbit(x.lane[i]); });
    }
    static Float sqrt(const Float& x) {
        return Float::map([&](int i) { return __builtin_sqrtf(x.lane[i]); });
    }
    static Float multiply_add(const Float& a, const Float& b, const Float& c) { return a * b + c; }
    static Float fused(const Float& a, const Float& b, const Float& c) {
        // Not std::fma: some C libraries round it wrongly, musl's without rounding modes to set.
        Float result;
        for (int i = 0; i < kWidth; i += 2) {
            const auto two = [&](const Float& x) { return Double2{x.lane[i], x.lane[i + 1]}; };
            const Double2 odd = fused_to_odd(two(a), two(b), two(c));
            for (int k = 0; k < 2; ++k) result.lane[i + k] = static_cast<float>(odd[k]);
        }
        return result;
    }

    static unsigned less(const Float& a, const Float& b) {
        return bits([&](int i) { return a.lane[i] < b.lane[i]; });
    }
    static unsigned less_equal(const Float& a, const Float& b) {
        return bits([&](int i) { return a.lane[i] <= b.lane[i]; });
    }
    static unsigned equal(const Float& a, const Float& b) {
        return bits([&](int i) { return a.lane[i] == b.lane[i]; });
    }
    static unsigned equal(const Int& a, const Int& b) {
        return bits([&](int i) { return a.lane[i] == b.lane[i]; });
    }

    template <class T>
    static Lanes<T> compress(unsigned mask, const Lanes<T>& x) {
        Lanes<T> result = {};
        int end = 0;
        for (int i = 0; i < kWidth; ++i) {
            if (mask >> i & 1) result.lane[end++] = x.lane[i];
        }
        return result;
    }

    static constexpr int kOrderBits = 4;
    static Int order(const std::uint32_t* packed, int octant) {
        return Int::map([&](int i) { return packed[i] >> (kOrderBits * octant) & 3; });
    }
    template <class T>
    static Lanes<T> permute(const Lanes<T>& x, const Int& order) {
        return Lanes<T>::map([&](int i) { return x.lane[order.lane[i]]; });
    }

    static Float as_float(const Int& x) {
        Float result;
        std::memcpy(&result, &x, sizeof(result));
        return result;
    }

    static void load_records(const float* p, Float (&field)[8]) {
        for (int i = 0; i < 8; ++i)
            field[i] = Float::map([&](int lane) { return p[8 * lane + i]; });
    }
    static void store_records(float* p, const Float (&field)[8]) {
        for (int i = 0; i < 8; ++i) {
            // Bits, since one of the fields isn't a float.
            for (int lane = 0; lane < kWidth; ++lane)
                std::memcpy(p + 8 * lane + i, &field[i].lane[lane], sizeof(float));
        }
    }

    static Float select(unsigned mask, const Float& a, const Float& b) {
        return Float::map([&](int i) { return mask >> i & 1 ? a.lane[i] : b.lane[i]; });
    }
    static void store_masked(unsigned mask, float* p, const Float& x) {
        for (; mask != 0; mask &= mask - 1) p[__builtin_ctz(mask)] = x.lane[__builtin_ctz(mask)];
    }
    static void store_masked(unsigned mask, std::uint32_t* p, const Int& x) {
        for (; mask != 0; mask &= mask - 1) p[__builtin_ctz(mask)] = x.lane[__builtin_ctz(mask)];
    }

    static float greatest(const Float& x) {
        float greatest = x.lane[0];
        for (int i = 1; i < kWidth; ++i) {
            if (greatest < x.lane[i]) greatest = x.lane[i];
        }
        return greatest;
    }
    static float least(unsigned mask, const Float& x) {
        float least = x.lane[__builtin_ctz(mask)];
        for (int i = 0; i < kWidth; ++i) {
            if ((mask >> i & 1) && x.lane[i] < least) least = x.lane[i];
        }
        return least;
    }

private:
    template <class T>
    static void store_lanes(T* p, const Lanes<T>& x) {
        for (int i = 0; i < kWidth; ++i) p[i] = x.lane[i];
    }
    template <class F>
    static unsigned bits(const F& is_set) {
        unsigned mask = 0;
        for (int i = 0; i < kWidth; ++i) mask |= unsigned{is_set(i)} << i;
        return mask;
    }
};

}  // namespace boxwood
