// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace boxwood {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Asks the system for huge pages, as far as they fit, behind memory that nobody has touched yet:
/// its first touch then costs a fault for each of them and not for each of 512 small ones. Where
/// the system has none to give, nothing happens.
void prefer_huge_pages(void* memory, std::size_t size) noexcept;

/// Makes an empty vector that large, for its values to be written, on huge pages if it can be.
/// Throws std::bad_alloc.
template <class Value>
void resize_on_huge_pages(std::vector<Value>& values, std::size_t count) {
    values.reserve(count);
    prefer_huge_pages(values.data(), count * sizeof(Value));
    values.resize(count);
}

}  // namespace boxwood
