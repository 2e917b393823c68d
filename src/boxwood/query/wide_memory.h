// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <memory>
#include <span>
#include <utility>

#include "boxwood/core/arena.h"

namespace boxwood {

/// Where a wide tree lies: in an arena of its own, or in memory that can't be written to, such as a
/// mapped file. Move-only.
class WideMemory {
public:
    WideMemory() = default;
    explicit WideMemory(Arena arena) : arena_(std::move(arena)) {
        bytes_ = {arena_.data(), arena_.size()};
    }
    /// Bytes that stay as they are for as long as the owner lives.
    WideMemory(std::span<const std::byte> bytes, std::shared_ptr<const void> owner)
        : bytes_(bytes), owner_(std::move(owner)) {}

    const std::byte* data() const { return bytes_.data(); }
    std::size_t size() const { return bytes_.size(); }

    /// The same bytes for writing: what isn't in an arena moves to one.
    std::byte* writable() {
        if (owner_) {
            Arena copy(size());
            std::memcpy(copy.data(), data(), size());
            *this = WideMemory(std::move(copy));
        }
        return arena_.data();
    }

private:
    Arena arena_;
    std::span<const std::byte> bytes_;
    std::shared_ptr<const void> owner_;
};

}  // namespace boxwood
