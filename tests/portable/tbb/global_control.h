// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tbb {

/// Stands in for TBB's, where there is one thread.
class global_control {
public:
    enum parameter { max_allowed_parallelism };

    global_control(parameter, std::size_t) {}
    static std::size_t active_value(parameter) { return 1; }
};

}  // namespace tbb
