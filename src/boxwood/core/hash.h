// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace boxwood {

/// Tells bytes apart that differ by accident; no guard against somebody who makes them alike. The
/// XXH3 hash of the XXH3 hashes of each MiB, so that all cores share the work. O(n).
std::uint64_t hash_of(std::span<const std::byte> bytes);

}  // namespace boxwood
