// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>

#include "boxwood/build/reference.h"
#include "boxwood/build/sah.h"

namespace boxwood {

/// How to cut a set of references in two, each with its box.
struct ObjectSplit {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;            ///< -1: there is none
    std::uint32_t place = 0;  ///< the first bin, or the first rank, of the right side
    WideBox left, right;
};

constexpr std::uint32_t kMostBins = 32;
/// Up to so many references can be swept.
constexpr std::uint32_t kFew = 16;

/// The cheapest split at the borders of the bins into which centres fall. O(references + bins).
ObjectSplit best_binned_split(std::span<const Reference> references, const Sah& sah,
                              const Grid& grid, std::uint32_t bins);

/// The places of few references in the order of their centres along an axis; equal ones stay as
/// they are.
using Ranks = std::array<std::int32_t, kFew>;

/// The cheapest of all splits of at most kFew references in the order of their centres along an
/// axis; `ranks` is that order.
ObjectSplit best_swept_split(std::span<const Reference> references, const Sah& sah, Ranks& ranks);

}  // namespace boxwood
