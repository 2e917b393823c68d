// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

/// A request to stop, from whoever has had enough to work that runs on other threads.
class Cancellation {
public:
    /// May be called from any thread, and from a signal handler.
    void request() noexcept { is_requested_.store(true, std::memory_order_relaxed); }
    bool is_requested() const noexcept { return is_requested_.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> is_requested_ = false;
    static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");
};

/// How a long piece of work runs, and how it is watched.
struct BatchOptions {
    /// Called now and then, about a thousand times at the most or twenty times a second where that
    /// is more, with the part that is done: growing, at last 1, on the thread that called. It may
    /// run batches of its own. What it throws ends the work and is thrown by it.
    std::function<void(double)> progress = {};
    /// Looked at now and then; once it is requested, the work stops and throws Cancelled. It must
    /// outlive the work.
    const Cancellation* cancellation = nullptr;
    /// Stays on the thread that calls. For callers that keep all cores busy already; others may
    /// call from parallel loops, too, as those share their threads with the work inside.
    bool on_this_thread = false;
};

/// Tells, on the thread that it was made on, how far work has come. No worker waits for that.
class ProgressReport {
public:
    ProgressReport(std::size_t total, const std::function<void(double)>& progress)
        : total_(total), progress_(progress) {}

    /// From any thread: so much more is done.
    void add(std::size_t count) {
        if (!progress_) return;
        done_.fetch_add(count);
        if (std::this_thread::get_id() == reporter_) report();
    }

    /// The last report. Precondition: all is added, and all of that has happened.
    void finish() {
        if (progress_) report();
    }

private:
    using Clock = std::chrono::steady_clock;

    void report() {
        constexpr std::size_t kMostReports = 1000;
        constexpr auto kLongest = std::chrono::milliseconds(50);  ///< between reports
        const std::size_t done = done_.load();
        const auto now = Clock::now();
        if (done < next_ && (done <= reported_ || now - last_report_ < kLongest)) return;
        reported_ = done;
        last_report_ = now;
        next_ = done < total_ ? std::min(done + total_ / kMostReports + 1, total_) : total_ + 1;
        progress_(static_cast<double>(done) / static_cast<double>(total_));
    }

    std::size_t total_;
    const std::function<void(double)>& progress_;
    std::thread::id reporter_ = std::this_thread::get_id();
    std::atomic<std::size_t> done_ = 0;
    std::size_t reported_ = 0, next_ = 1;  ///< to report at
    Clock::time_point last_report_ = Clock::now();
};

/// Calls body(begin, end) for pieces of [0, count), each of the given size but the last, on all
/// cores. Throws Cancelled, and what body or the progress throws, after the last piece has ended.
template <class Body>
void for_each_piece(std::size_t count, std::size_t piece, const BatchOptions& options,
                    const Body& body) {
    if (count == 0) return;
    ProgressReport report(count, options.progress);
    const auto run = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (options.cancellation && options.cancellation->is_requested())
                throw Cancelled("cancelled by the caller");
            const std::size_t begin = i * piece, end = std::min(begin + piece, count);
            body(begin, end);
            report.add(end - begin);
        }
    };
    const std::size_t pieces = (count + piece - 1) / piece;
    if (options.on_this_thread) {
        run(0, pieces);
    } else {
        // A thread that waits for the last pieces mustn't take up work from outside: whoever calls
        // from a parallel loop may hold a lock.
        tbb::this_task_arena::isolate([&] { parallel_for(pieces, 1, run); });
    }
    report.finish();
}

}  // namespace boxwood
