// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tbb/blocked_range.h"

namespace tbb {

/// Stands in for TBB's, on one thread.
template <class Range, class Value, class Body, class Combine>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body, const Combine&) {
    return body(range, identity);
}

}  // namespace tbb
