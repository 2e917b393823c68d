// SPDX-License-Identifier: Apache-2.0
// Work without the interpreter's lock, and forks, which have to wait for it: a child has only the
// thread that forked, so what others had in their hands, locks of the scheduler above all, stays so
// there for good. Atomics alone, as they mean the same in the child.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace boxwood::python {

/// Counts the threads at work, and the forks that wait for them.
class ForkGate {
public:
    /// Waits while another thread forks, unless that waits for this one already.
    static void enter() {
        while (depth_ == 0) {
            ++working_;
            if (forks_ == 0) break;
            --working_;
            while (forks_ > 0) pause();
        }
        ++depth_;
    }
    static void leave() {
        if (--depth_ == 0) --working_;
    }

    /// Keeps new work out and waits, for some seconds at the most, until only this thread may be
    /// at work. To be called without the interpreter's lock.
    static void before_fork() {
        constexpr auto kLongest = std::chrono::seconds(10);
        ++forks_;
        const auto start = std::chrono::steady_clock::now();
        const int own = depth_ > 0 ? 1 : 0;
        while (working_ > own && std::chrono::steady_clock::now() - start < kLongest) pause();
    }
    static void after_fork_in_parent() { --forks_; }
    static void after_fork_in_child() {
        forks_ = 0;
        working_ = depth_ > 0 ? 1 : 0;
    }

    static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

private:
    inline static std::atomic<int> working_ = 0, forks_ = 0;
    inline static thread_local int depth_ = 0;
};

/// While it lives, the interpreter is free and this thread is at work.
class Unlocked {
public:
    Unlocked() { ForkGate::enter(); }
    ~Unlocked() { ForkGate::leave(); }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

private:
    nanobind::gil_scoped_release released_;
};

}  // namespace boxwood::python
