// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace boxwood::cli {

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (visible_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double part) {
    constexpr int kWidth = 40;
    constexpr auto kInterval = std::chrono::milliseconds(100);
    const auto now = Clock::now();
    if (!visible_ || now - last_shown_ < kInterval) return;
    last_shown_ = now;

    const std::chrono::duration<double> elapsed = now - start_;
    const double left = part > 0 ? elapsed.count() / part - elapsed.count() : 0;
    const auto filled = static_cast<std::size_t>(part * kWidth);
    fmt::print(stderr, "\r[{}{}] {:3.0f} %  {:.0f} s left \x1b[K", std::string(filled, '#'),
               std::string(kWidth - filled, '.'), 100 * part, left);
    std::fflush(stderr);
}

}  // namespace boxwood::cli
