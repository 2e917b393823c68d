// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

namespace boxwood {

/// Asks for the memory of what lies some places ahead of the i-th, to be read or, if it isn't
/// const, written: for loops over what is too large for processors to look ahead far enough. A ray
/// in double with its hit takes as much memory as two cache lines.
template <class T>
void fetch_ahead(std::span<T> all, std::size_t i) {
    constexpr std::size_t kAhead = 16, kLine = 64;
    if (i + kAhead >= all.size()) return;
    const auto* bytes = reinterpret_cast<const std::byte*>(&all[i + kAhead]);
    for (std::size_t line = 0; line < sizeof(T); line += kLine)
        __builtin_prefetch(bytes + line, std::is_const_v<T> ? 0 : 1);
}

}  // namespace boxwood
