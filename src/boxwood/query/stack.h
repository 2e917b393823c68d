// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxwood {

/// The nodes that a traversal comes back to. A tree of depth d needs at most d places; ordinary
/// trees stay within those at hand, and a degenerate one takes memory from the heap.
template <class Entry>
class Stack {
public:
    bool is_empty() const { return size_ == 0; }

    void push(const Entry& entry) {
        if (size_ < kAtHand) {
            at_hand_[size_] = entry;
        } else {
            more_.push_back(entry);
        }
        ++size_;
    }

    Entry pop() {
        --size_;
        if (size_ < kAtHand) return at_hand_[size_];
        const Entry entry = more_.back();
        more_.pop_back();
        return entry;
    }

private:
    static constexpr std::size_t kAtHand = 80;

    std::array<Entry, kAtHand> at_hand_;
    std::size_t size_ = 0;
    std::vector<Entry> more_;
};

}  // namespace boxwood
