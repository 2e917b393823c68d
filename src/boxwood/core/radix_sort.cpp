// SPDX-License-Identifier: Apache-2.0
// Sorting digit by digit: count how often each digit occurs, so that each knows where its first key
// goes, and send the keys there in their order. Blocks of keys are counted side by side and sent
// side by side: a block's keys of one digit go behind those of the blocks before it.
// Source: Zagha and Blelloch, "Radix Sort for Vector Multiprocessors", Supercomputing 1991.
#include "boxwood/core/radix_sort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

/// 1024 counters, and as many places to write to, stay in the first-level cache.
constexpr int kDigitBits = 10;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
/// Fewer keys than this are faster sorted by comparing them.
constexpr std::size_t kFewKeys = 64;
/// Keys are asked for so early: machines that look ahead by themselves stop where a page ends.
constexpr std::size_t kAhead = 256;

void sort_by_insertion(std::span<std::uint64_t> keys, std::uint64_t mask) {
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const std::uint64_t key = keys[i];
        std::size_t place = i;
        for (; place > 0 && (keys[place - 1] & mask) > (key & mask); --place)
            keys[place] = keys[place - 1];
        keys[place] = key;
    }
}

class Pass {
public:
    Pass(std::size_t count, int shift, std::uint64_t mask)
        : count_(count),
          block_(std::max<std::size_t>(count / 64, std::size_t{1} << 14)),
          shift_(shift),
          mask_(mask),
          places_((count + block_ - 1) / block_ * kDigits) {}

    /// False when all keys have the same digit: then nothing is to be done.
    bool count(std::span<const std::uint64_t> keys) {
        for_each_block([&](std::size_t begin, std::size_t end, std::uint32_t* place) {
            for (std::size_t i = begin; i < end; ++i) {
                __builtin_prefetch(&keys[std::min(i + kAhead, count_ - 1)]);
                ++place[digit(keys[i])];
            }
        });
        // Row by row: columns, 4096 bytes apart, would share few lines of the cache.
        std::array<std::uint32_t, kDigits> next = {};
        for_each_row([&](std::uint32_t* row) {
            for (std::size_t d = 0; d < kDigits; ++d) next[d] += row[d];
        });
        if (std::find(next.begin(), next.end(), count_) != next.end()) return false;
        std::exclusive_scan(next.begin(), next.end(), next.begin(), 0u);
        for_each_row([&](std::uint32_t* row) {
            for (std::size_t d = 0; d < kDigits; ++d) next[d] += std::exchange(row[d], next[d]);
        });
        return true;
    }

    void move(std::span<const std::uint64_t> from, std::span<std::uint64_t> to) {
        for_each_block([&](std::size_t begin, std::size_t end, std::uint32_t* place) {
            for (std::size_t i = begin; i < end; ++i) {
                __builtin_prefetch(&from[std::min(i + kAhead, count_ - 1)]);
                to[place[digit(from[i])]++] = from[i];
            }
        });
    }

private:
    std::size_t digit(std::uint64_t key) const { return (key >> shift_) & mask_; }

    template <class Body>
    void for_each_row(const Body& body) {
        for (std::size_t i = 0; i < places_.size(); i += kDigits) body(&places_[i]);
    }
    template <class Body>
    void for_each_block(const Body& body) {
        parallel_for(places_.size() / kDigits, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t b = first; b < last; ++b)
                body(b * block_, std::min((b + 1) * block_, count_), &places_[b * kDigits]);
        });
    }

    std::size_t count_, block_;
    int shift_;
    std::uint64_t mask_;
    std::vector<std::uint32_t> places_;  ///< of each block, for each digit
};

}  // namespace

void radix_sort(std::span<std::uint64_t> keys, std::span<std::uint64_t> sorted, int first_bit,
                int bits) {
    const auto mask_of = [](int width) { return (std::uint64_t{1} << width) - 1; };
    std::span<std::uint64_t> from = keys, to = sorted;
    if (keys.size() < kFewKeys) {
        sort_by_insertion(keys, mask_of(bits) << first_bit);
    } else {
        for (int done = 0; done < bits; done += kDigitBits) {
            Pass pass(keys.size(), first_bit + done, mask_of(std::min(kDigitBits, bits - done)));
            if (!pass.count(from)) continue;
            pass.move(from, to);
            std::swap(from, to);
        }
    }
    if (from.data() == sorted.data()) return;
    parallel_for(keys.size(), std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
        std::copy(from.begin() + begin, from.begin() + end, sorted.begin() + begin);
    });
}

}  // namespace boxwood
