// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace boxwood {

/// Sorts the keys by their bits [first_bit, first_bit + bits) alone; equal ones keep their order.
/// Least significant digit first, in O(n) time for each ten bits, on all cores. Precondition:
/// scratch is as large as keys; what it holds afterwards is of no use.
void radix_sort(std::span<std::uint64_t> keys, std::span<std::uint64_t> scratch, int first_bit,
                int bits);

}  // namespace boxwood
