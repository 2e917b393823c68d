// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/arena.h"

#include <cstdlib>
#include <new>

#include "boxwood/core/huge_pages.h"

namespace boxwood {

namespace {

constexpr std::size_t kCacheLine = 64;

std::size_t rounded_up(std::size_t size, std::size_t unit) {
    return (size + unit - 1) / unit * unit;
}

}  // namespace

Arena::Arena(std::size_t size) : size_(size) {
    if (size == 0) return;
    // Less than a huge page would waste most of it.
    const std::size_t alignment = size < kHugePage ? kCacheLine : kHugePage;
    const std::size_t rounded = rounded_up(size, alignment);
    void* memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
    prefer_huge_pages(memory, rounded);
    memory_.reset(static_cast<std::byte*>(memory));
}

void Arena::Free::operator()(std::byte* memory) const { std::free(memory); }

}  // namespace boxwood
