// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace boxwood {

/// A block of memory for data that is read in no order: aligned to the system's huge pages, and on
/// them where the system grants it, so that few look-ups of addresses miss. Not initialised.
class Arena {
public:
    Arena() = default;
    /// Throws std::bad_alloc.
    explicit Arena(std::size_t size);

    std::byte* data() const { return memory_.get(); }
    std::size_t size() const { return size_; }
    std::span<std::byte> bytes() const { return {data(), size_}; }
    /// Keeps the memory, and uses less of it. Precondition: it isn't more.
    void shrink(std::size_t size) { size_ = size; }

private:
    struct Free {
        void operator()(std::byte* memory) const;
    };
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t size_ = 0;
};

}  // namespace boxwood
