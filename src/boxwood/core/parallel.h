// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace boxwood {

/// How many threads share the work of parallel_for.
inline std::size_t thread_count() {
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

/// Calls body(begin, end) over pieces of [0, count) of at least the given size, on all cores.
template <class Body>
void parallel_for(std::size_t count, std::size_t smallest_piece, const Body& body) {
    if (count <= smallest_piece) {
        if (count > 0) body(std::size_t{0}, count);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, smallest_piece),
                      [&](const auto& range) { body(range.begin(), range.end()); });
}

/// Combines what map(begin, end) gives for pieces of [0, count) of at least the given size;
/// identity for none. How many pieces there are depends on the threads, so combining must not
/// round.
template <class Value, class Map, class Combine>
Value parallel_reduce(std::size_t count, std::size_t smallest_piece, const Value& identity,
                      const Map& map, const Combine& combine) {
    if (count <= smallest_piece) return count > 0 ? map(std::size_t{0}, count) : identity;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, count, smallest_piece), identity,
        [&](const auto& range, const Value& value) {
            return combine(value, map(range.begin(), range.end()));
        },
        combine);
}

/// Calls both functions, side by side where the work is worth a task.
template <class First, class Second>
void invoke_both(bool side_by_side, const First& first, const Second& second) {
    if (side_by_side) {
        tbb::parallel_invoke(first, second);
    } else {
        first();
        second();
    }
}

/// While it lives, the library uses at most this many threads; 0 means all cores.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t threads)
        : control_(tbb::global_control::max_allowed_parallelism,
                   threads > 0 ? threads
                               : tbb::global_control::active_value(
                                     tbb::global_control::max_allowed_parallelism)) {}

private:
    tbb::global_control control_;
};

}  // namespace boxwood
