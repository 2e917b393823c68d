// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tbb {

/// Stands in for TBB's, where there is one thread.
template <class T>
class enumerable_thread_specific {
public:
    T& local() { return value_; }

private:
    T value_{};
};

}  // namespace tbb
