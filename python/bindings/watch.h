// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <cstddef>
#include <exception>

#include "boxwood/core/batch.h"
#include "unlocked.h"

namespace boxwood::python {

/// Long work without the interpreter's lock. The thread that called looks back now and then: at
/// Ctrl-C, and to report progress. All calls into Python are made there, so that neither a
/// traceback nor a progress bar meets another thread.
class Watch {
public:
    /// `progress` is None or takes the part that is done, from 0 to 1; of work on so many things.
    Watch(std::size_t total, nanobind::handle progress) : total_(total), progress_(progress) {}

    /// How a batch of so many of the things runs; they are counted as it goes. It throws what
    /// Python has to say; the work that is left then is cancelled.
    BatchOptions options(std::size_t count) {
        const auto report = [this, count, before = done_](double part) {
            done_ = before + static_cast<std::size_t>(part * static_cast<double>(count));
            look_now_and_then();
        };
        return {.progress = report, .cancellation = &cancellation_};
    }

    /// Calls body(begin, end) for pieces of all that there is, on all cores.
    template <class Body>
    void for_each_piece(std::size_t piece, const Body& body) {
        boxwood::for_each_piece(total_, piece, options(total_), body);
    }

    /// The last report. To be called on the thread that called, when all is done.
    void finish() {
        if (!progress_.is_none()) look();
    }

    /// What Python had to say, if it ended the work.
    const std::exception_ptr& failure() const { return failure_; }

private:
    using Clock = std::chrono::steady_clock;

    void look_now_and_then() {
        constexpr auto kBetweenLooks = std::chrono::milliseconds(50);
        const auto now = Clock::now();
        if (now - last_look_ < kBetweenLooks) return;
        last_look_ = now;
        look();
    }

    void look() {
        const nanobind::gil_scoped_acquire lock;
        try {
            if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
            if (!progress_.is_none())
                progress_(total_ > 0 ? static_cast<double>(done_) / total_ : 1.0);
        } catch (...) {
            failure_ = std::current_exception();
            cancellation_.request();
            throw;
        }
    }

    std::size_t total_;
    nanobind::handle progress_;
    Cancellation cancellation_;
    std::exception_ptr failure_;
    std::size_t done_ = 0;
    Clock::time_point last_look_ = Clock::now();
};

/// Runs work(watch) without the interpreter's lock.
template <class Work>
void run_watched(std::size_t total, nanobind::handle progress, const Work& work) {
    Watch watch(total, progress);
    const Unlocked unlocked;
    try {
        work(watch);
        watch.finish();
    } catch (const Cancelled&) {
        // Another thread gave up before word of the reason got through.
        if (watch.failure()) std::rethrow_exception(watch.failure());
        throw;
    }
}

}  // namespace boxwood::python
