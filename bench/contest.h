// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "peers/peer.h"
#include "ray_sets.h"

namespace boxwood::bench {

/// Somebody who traces rays: a tree, and how it is asked.
struct Contestant {
    std::string library;
    std::string name;
    const Accelerator* tree;
    Mode mode = Mode::single;
    int threads = 1;
};

/// How somebody did on the rays of one kind on one mesh.
struct Score {
    std::string mesh;
    RayKind kind;
    std::string library;
    std::string name;
    Mode mode;
    int threads;
    double mrays;  ///< million rays a second: the median of the passes
    std::size_t rays;
    std::size_t
        wrong_hits;       ///< rays that hit where they should miss, or miss where they should hit
    std::size_t wrong_t;  ///< rays that hit at another t, relative difference beyond 1e-4
};

/// All contestants trace the rays in turn, pass by pass, so that what disturbs the machine disturbs
/// all of them. Before that each traces them once, to warm up and to be checked; who is twenty
/// times slower than the fastest has its time taken there and takes no part in the passes.
std::vector<Score> run_contest(const std::string& mesh, const RaySet& set,
                               const std::vector<Contestant>& contestants, int passes);

/// "single", "packets of 8" ...
std::string_view name_of(Mode mode);

/// Processor time of the calling thread.
double thread_seconds();

/// Seconds for work(begin, end) on all of [0, count). One thread is timed by its processor
/// time, so that other programs disturb less, and threads that a library keeps awake don't count;
/// several threads, by the clock, take pieces as they come.
double seconds_of(int threads, std::size_t count,
                  const std::function<void(std::size_t, std::size_t)>& work);

double median(std::vector<double> values);

}  // namespace boxwood::bench
