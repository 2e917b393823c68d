// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace boxwood {

/// The nodes that a traversal comes back to; no more than fit.
template <class Entry, std::size_t kCapacity>
class Stack {
public:
    bool is_empty() const { return size_ == 0; }
    bool is_full() const { return size_ == kCapacity; }

    /// Precondition: it isn't full.
    void push(const Entry& entry) { entries_[size_++] = entry; }
    /// Precondition: it isn't empty.
    Entry pop() { return entries_[--size_]; }

private:
    std::array<Entry, kCapacity> entries_;
    std::size_t size_ = 0;
};

}  // namespace boxwood
