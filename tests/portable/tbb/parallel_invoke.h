// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tbb {

/// Stands in for TBB's, on one thread.
template <class... Functions>
void parallel_invoke(const Functions&... functions) {
    (functions(), ...);
}

}  // namespace tbb
