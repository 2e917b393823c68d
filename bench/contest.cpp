// SPDX-License-Identifier: Apache-2.0
#include "contest.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <thread>

#include "cli/stopwatch.h"

namespace boxwood::bench {

namespace {

/// What contestants write into, one for all.
struct Answers {
    std::vector<PlainHit> closest;
    std::vector<std::uint8_t> any;
};

void trace(const Contestant& who, const RaySet& set, std::size_t begin, std::size_t end,
           Answers& answers) {
    const auto rays = std::span(set.rays).subspan(begin, end - begin);
    if (set.wants_any())
        who.tree->any_hits(who.mode, rays, answers.any.data() + begin);
    else
        who.tree->closest_hits(who.mode, rays, answers.closest.data() + begin);
}

double time_pass(const Contestant& who, const RaySet& set, Answers& answers) {
    return seconds_of(who.threads, set.rays.size(), [&](std::size_t begin, std::size_t end) {
        trace(who, set, begin, end, answers);
    });
}

void check(const RaySet& set, const Answers& answers, Score& score) {
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        const double truth = set.truth[i];
        const PlainHit& closest = answers.closest[i];
        const bool hit = set.wants_any() ? answers.any[i] != 0 : closest.triangle != kNoTriangle;
        if (hit != std::isfinite(truth))
            ++score.wrong_hits;
        else if (!set.wants_any() && hit && !(std::abs(closest.t - truth) <= 1e-4 * truth))
            ++score.wrong_t;
    }
}

}  // namespace

double thread_seconds() {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(int threads, std::size_t count,
                  const std::function<void(std::size_t, std::size_t)>& work) {
    constexpr std::size_t kPiece = 8192;
    if (threads == 1) {
        const double start = thread_seconds();
        work(0, count);
        return thread_seconds() - start;
    }
    cli::Stopwatch stopwatch;
    std::atomic<std::size_t> next = 0;
    const auto take_pieces = [&] {
        for (std::size_t begin; (begin = next.fetch_add(kPiece)) < count;)
            work(begin, std::min(begin + kPiece, count));
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(take_pieces);
    take_pieces();
    for (std::thread& thread : others) thread.join();
    return stopwatch.lap();
}

std::vector<Score> run_contest(const std::string& mesh, const RaySet& set,
                               const std::vector<Contestant>& contestants, int passes) {
    constexpr double kTooSlow = 20;
    Answers answers = {std::vector<PlainHit>(set.rays.size()),
                       std::vector<std::uint8_t>(set.rays.size())};
    std::vector<Score> scores;
    std::vector<std::vector<double>> seconds(contestants.size());
    double fastest = 1e30;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        const Contestant& who = contestants[i];
        // What the one before wrote must not pass for an answer.
        std::fill(answers.closest.begin(), answers.closest.end(),
                  PlainHit{-1, 0, 0, kNoTriangle - 1, 0, 0, 0, 0});
        std::fill(answers.any.begin(), answers.any.end(), std::uint8_t{2});
        seconds[i].push_back(time_pass(who, set, answers));
        fastest = std::min(fastest, seconds[i][0]);
        scores.push_back({mesh, set.kind, who.library, who.name, who.mode, who.threads, 0,
                          set.rays.size(), 0, 0});
        check(set, answers, scores.back());
    }
    std::vector<bool> takes_part(contestants.size());
    for (std::size_t i = 0; i < contestants.size(); ++i)
        takes_part[i] = seconds[i][0] < kTooSlow * fastest;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            if (!takes_part[i]) continue;
            if (pass == 0) seconds[i].clear();
            seconds[i].push_back(time_pass(contestants[i], set, answers));
        }
    }
    for (std::size_t i = 0; i < contestants.size(); ++i)
        scores[i].mrays = 1e-6 * static_cast<double>(set.rays.size()) / median(seconds[i]);
    return scores;
}

std::string_view name_of(Mode mode) {
    constexpr std::string_view kNames[] = {"single", "packets of 8", "packets of 16",
                                           "coherent packets of 16", "batch"};
    return kNames[static_cast<int>(mode)];
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace boxwood::bench
