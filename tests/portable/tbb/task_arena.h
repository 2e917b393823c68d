// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tbb::this_task_arena {

// Stand in for TBB's, on one thread.
template <class Function>
void isolate(const Function& function) {
    function();
}

inline int max_concurrency() { return 1; }

}  // namespace tbb::this_task_arena
