// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace boxwood {

/// A bijection of 64 bits in which each bit of the input flips each bit of the output with a
/// probability of about one half. Source: the finalizer of SplitMix64, in Steele, Lea and Flood,
/// "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014, with Stafford's constants Mix13.
inline std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A random number in [0, 1) that is a function of its name alone: no state to keep or to share, so
/// work may be split in any way and done in any order. The index is what counts (a sample, a
/// vertex), the dimension tells apart the numbers that one of it needs. The same on every machine.
inline double uniform(std::uint64_t seed, std::uint64_t index, std::uint32_t dimension) {
    // The odd constant, the golden ratio's fraction, keeps names of all zeros off the fixed point
    // 0.
    constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
    const std::uint64_t of_seed = mix_bits(seed + kStep);
    const std::uint64_t of_index = mix_bits(of_seed + index * kStep);
    const std::uint64_t bits = mix_bits(of_index + (dimension + std::uint64_t{1}) * kStep);
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace boxwood
