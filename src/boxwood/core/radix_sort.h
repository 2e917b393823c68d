// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace boxwood {

/// Writes the keys to another place of that size, in the order of their bits
/// [first_bit, first_bit + bits) alone; equal ones keep their order. Least significant digit first,
/// in O(n) time for each ten bits, on all cores. What the first place holds afterwards is of no
/// use.
void radix_sort(std::span<std::uint64_t> keys, std::span<std::uint64_t> sorted, int first_bit,
                int bits);

}  // namespace boxwood
