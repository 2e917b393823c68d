// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace boxwood {
namespace {

using Pieces = std::vector<std::pair<std::size_t, std::size_t>>;

/// What the body was called with, in order of place.
Pieces pieces_of(std::size_t count, std::size_t piece, const BatchOptions& options = {}) {
    Pieces pieces;
    std::mutex mutex;
    for_each_piece(count, piece, options, [&](std::size_t begin, std::size_t end) {
        const std::lock_guard lock(mutex);
        pieces.emplace_back(begin, end);
    });
    std::sort(pieces.begin(), pieces.end());
    return pieces;
}

TEST(Batch, pieces_have_their_size_but_the_last_and_cover_each_place_once) {
    for (const std::size_t threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        EXPECT_EQ(pieces_of(0, 10), Pieces{});
        EXPECT_EQ(pieces_of(1, 10), (Pieces{{0, 1}}));
        EXPECT_EQ(pieces_of(20, 10), (Pieces{{0, 10}, {10, 20}}));
        EXPECT_EQ(pieces_of(25, 10), (Pieces{{0, 10}, {10, 20}, {20, 25}}));
        EXPECT_EQ(pieces_of(1000, 1).size(), 1000u);
    }
}

TEST(Batch, stays_on_this_thread_when_asked_to) {
    const ThreadLimit limit(4);
    std::set<std::thread::id> threads;
    for_each_piece(1000, 1, {.on_this_thread = true},
                   [&](std::size_t, std::size_t) { threads.insert(std::this_thread::get_id()); });
    EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(Batch, progress_grows_to_1_on_the_thread_that_called_and_not_too_often) {
    for (const std::size_t threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {1, 7, 999, 1000, 1001, 50'000}) {
            std::vector<double> parts;
            std::atomic<bool> elsewhere = false;
            const auto caller = std::this_thread::get_id();
            const auto progress = [&](double part) {
                if (std::this_thread::get_id() == caller)
                    parts.push_back(part);
                else
                    elsewhere = true;
            };
            for_each_piece(count, 1, {.progress = progress}, [](std::size_t, std::size_t) {});
            EXPECT_FALSE(elsewhere);
            ASSERT_FALSE(parts.empty());
            EXPECT_LE(parts.size(), 1001u);
            EXPECT_GT(parts.front(), 0);
            EXPECT_EQ(parts.back(), 1);
            EXPECT_EQ(std::adjacent_find(parts.begin(), parts.end(), std::greater_equal<>()),
                      parts.end());
        }
    }
}

TEST(Batch, progress_counts_places_and_not_pieces) {
    std::vector<double> parts;
    for_each_piece(
        10, 4, {.progress = [&](double part) { parts.push_back(part); }, .on_this_thread = true},
        [](std::size_t, std::size_t) {});
    EXPECT_EQ(parts, (std::vector<double>{0.4, 0.8, 1}));
}

TEST(Batch, progress_may_run_a_batch_of_its_own) {
    const ThreadLimit limit(4);
    std::atomic<std::size_t> inner = 0;
    std::size_t calls = 0;
    const auto progress = [&](double) {
        ++calls;
        for_each_piece(100, 1, {}, [&](std::size_t, std::size_t) { ++inner; });
    };
    for_each_piece(200, 1, {.progress = progress}, [](std::size_t, std::size_t) {});
    EXPECT_EQ(inner, 100 * calls);
}

TEST(Batch, cancelled_before_it_starts_does_nothing) {
    Cancellation cancellation;
    cancellation.request();
    for (const bool here : {false, true}) {
        bool called = false;
        EXPECT_THROW(
            for_each_piece(100, 10, {.cancellation = &cancellation, .on_this_thread = here},
                           [&](std::size_t, std::size_t) { called = true; }),
            Cancelled);
        EXPECT_FALSE(called);
    }
}

TEST(Batch, cancelled_halfway_throws_once_nobody_works_any_more) {
    constexpr std::size_t kCount = 100'000;
    for (const std::size_t threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        Cancellation cancellation;
        std::atomic<std::size_t> started = 0, ended = 0;
        const auto body = [&](std::size_t, std::size_t) {
            if (++started == 50) cancellation.request();
            std::this_thread::yield();
            ++ended;
        };
        EXPECT_THROW(for_each_piece(kCount, 1, {.cancellation = &cancellation}, body), Cancelled);
        EXPECT_EQ(started, ended);
        EXPECT_GE(started, 50u);
        EXPECT_LT(started, kCount);
    }
}

TEST(Batch, cancellation_after_the_last_piece_comes_too_late) {
    Cancellation cancellation;
    const auto progress = [&](double part) {
        if (part == 1) cancellation.request();
    };
    EXPECT_EQ(pieces_of(100, 10, {.progress = progress, .cancellation = &cancellation}).size(),
              10u);
}

TEST(Batch, progress_that_throws_ends_the_work) {
    const ThreadLimit limit(4);
    std::atomic<bool> thrown = false;
    std::atomic<std::size_t> done = 0;
    const auto progress = [&](double) {
        thrown = true;
        throw InvalidInput("enough");
    };
    const auto caller = std::this_thread::get_id();
    const auto body = [&](std::size_t, std::size_t) {
        while (!thrown && std::this_thread::get_id() != caller) std::this_thread::yield();
        ++done;
    };
    EXPECT_THROW(for_each_piece(100'000, 1, {.progress = progress}, body), InvalidInput);
    EXPECT_LT(done, 100'000u);
}

TEST(Batch, batches_inside_a_parallel_loop_take_no_more_threads_than_it_may) {
    constexpr int kThreads = 3;
    const ThreadLimit limit(kThreads);
    std::atomic<int> running = 0, most = 0, total = 0;
    parallel_for(20, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for_each_piece(50, 1, {}, [&](std::size_t, std::size_t) {
                const int now = ++running;
                int seen = most;
                while (seen < now && !most.compare_exchange_weak(seen, now)) {
                }
                std::this_thread::yield();
                ++total;
                --running;
            });
        }
    });
    EXPECT_EQ(total, 20 * 50);
    EXPECT_LE(most, kThreads);
}

TEST(Batch, a_thread_that_waits_for_its_batch_takes_up_no_work_from_outside) {
    const ThreadLimit limit(4);
    // As a lock would be that the outer body holds.
    static thread_local bool is_inside = false;
    std::atomic<int> entered_twice = 0;
    parallel_for(200, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            entered_twice += is_inside;
            is_inside = true;
            for_each_piece(20, 1, {}, [](std::size_t, std::size_t) { std::this_thread::yield(); });
            is_inside = false;
        }
    });
    EXPECT_EQ(entered_twice, 0);
}

}  // namespace
}  // namespace boxwood
