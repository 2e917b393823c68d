// SPDX-License-Identifier: Apache-2.0
// What the files of saved trees and of saved scenes have in common: how they begin, where their
// arrays lie, and a checksum of all that is in front of the arrays. Explained in
// docs/guide/saved_trees.md.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "boxwood/core/hash.h"

namespace boxwood {

/// Arrays begin at multiples of it: a page on most systems, so that few are read for nothing.
constexpr std::size_t kSavedAlignment = std::size_t{1} << 12;

constexpr std::uint64_t aligned_to_page(std::uint64_t bytes) {
    return (bytes + kSavedAlignment - 1) / kSavedAlignment * kSavedAlignment;
}

/// The first bytes of a file.
struct SavedStart {
    static constexpr std::uint32_t kByteOrder = 0x01020304, kSwappedByteOrder = 0x04030201;

    std::array<char, 8> magic;
    std::uint32_t byte_order = kByteOrder;
    std::uint32_t version = 1;

    /// Bytes that no text has, and line ends that a copy as text would change.
    static constexpr SavedStart of(char kind) {
        return {{'\x89', 'B', 'X', kind, '\r', '\n', '\x1a', '\n'}};
    }
};
static_assert(sizeof(SavedStart) == 16);

/// Reads a header that begins with a SavedStart named `start`. Calls fail(place, message), which
/// throws, where it is another file, one of another machine or another version.
template <class Header, class Fail>
Header read_saved_header(std::span<const std::byte> bytes, const char* what, const Fail& fail) {
    const SavedStart expected = Header().start;
    Header header;
    const std::size_t size = bytes.size() < sizeof(Header) ? bytes.size() : sizeof(Header);
    if (size > 0) std::memcpy(&header, bytes.data(), size);
    const SavedStart& found = header.start;
    if (size < sizeof(found.magic) || found.magic != expected.magic)
        fail("byte 0", fmt::format("found no saved {}, expected one", what));
    if (size < sizeof(Header))
        fail("", fmt::format("found {} bytes, expected at least {}", size, sizeof(Header)));
    if (found.byte_order == SavedStart::kSwappedByteOrder)
        fail("byte 8", "found the byte order of another kind of machine, expected this one's");
    if (found.byte_order != expected.byte_order)
        fail("byte 8", fmt::format("found {:#010x}, expected the byte order {:#010x}",
                                   found.byte_order, expected.byte_order));
    if (found.version != expected.version)
        fail("byte 12",
             fmt::format("found version {}, expected {}{}", found.version, expected.version,
                         found.version > expected.version ? "; update Boxwood" : ""));
    return header;
}

/// The hash of a front that has its own hash at that place, as if there were zeros. O(n).
inline std::uint64_t hash_of_front(std::span<const std::byte> bytes, std::size_t place) {
    std::vector<std::byte> front(bytes.begin(), bytes.end());
    std::memset(front.data() + place, 0, sizeof(std::uint64_t));
    return hash_of(front);
}

/// Holds the hash at that place against the front.
template <class Fail>
void check_front_hash(std::span<const std::byte> front, std::size_t place, const Fail& fail) {
    std::uint64_t expected = 0;
    std::memcpy(&expected, front.data() + place, sizeof(expected));
    const std::uint64_t found = hash_of_front(front, place);
    if (found != expected)
        fail(fmt::format("byte {}", place),
             fmt::format("found a front of checksum {:016x}, expected {:016x}", found, expected));
}

}  // namespace boxwood
