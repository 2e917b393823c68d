// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

/// Does it pay to fetch ahead what rays visit next? Where the tree is larger than the caches and
/// rays go to places that none went to lately, it nearly doubles their speed; where they come back,
/// the places are in the cache and asking for them costs up to half of it. So watch a few visits.
class FetchTrial {
public:
    BOXWOOD_KERNEL void watch(WideReference reference) {
        // About as many places as the second cache holds, found by multiplicative hashing.
        WideReference& recent = recent_[reference * 0x9e3779b1u >> (32 - kLogPlaces)];
        if (visits_ >= kWarmUp) news_ += recent != reference;
        recent = reference;
        ++visits_;
    }

    BOXWOOD_KERNEL bool is_over() const { return visits_ >= kVisits; }

    /// Whether at least a quarter of the visits went to new places.
    BOXWOOD_KERNEL bool favors_fetching() const { return 4 * news_ > kVisits - kWarmUp; }

private:
    static constexpr int kLogPlaces = 11;
    static constexpr int kWarmUp = 512, kVisits = 1536;

    int visits_ = 0, news_ = 0;
    WideReference recent_[1 << kLogPlaces] = {};
};

}  // namespace boxwood
