// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tbb/blocked_range.h"

namespace tbb {

/// Stands in for TBB's, on one thread.
template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
    body(range);
}

}  // namespace tbb
