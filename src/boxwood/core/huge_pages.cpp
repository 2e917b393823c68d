// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/huge_pages.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace boxwood {

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size) noexcept {
#if defined(__linux__)
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::size_t skipped = (kHugePage - address % kHugePage) % kHugePage;
    if (size < skipped + kHugePage) return;
    madvise(static_cast<std::byte*>(memory) + skipped, (size - skipped) / kHugePage * kHugePage,
            MADV_HUGEPAGE);
#endif
}

}  // namespace boxwood
