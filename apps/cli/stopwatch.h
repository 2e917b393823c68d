// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace boxwood::cli {

/// Seconds since it was made or last asked.
class Stopwatch {
public:
    double lap() {
        const auto now = Clock::now();
        const std::chrono::duration<double> seconds = now - start_;
        start_ = now;
        return seconds.count();
    }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point start_ = Clock::now();
};

}  // namespace boxwood::cli
