// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tbb::this_task_arena {

/// Stands in for TBB's, on one thread.
template <class Function>
void isolate(const Function& function) {
    function();
}

}  // namespace tbb::this_task_arena
