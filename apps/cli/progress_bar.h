// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace boxwood::cli {

/// A bar on stderr with the part that is done and the time left; nothing where stderr isn't a
/// terminal or it is told to be quiet. Gone from the screen when it ends.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool is_visible() const { return visible_; }
    void show(double part);

private:
    using Clock = std::chrono::steady_clock;

    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = {};
};

}  // namespace boxwood::cli
