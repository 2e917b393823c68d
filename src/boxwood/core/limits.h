// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace boxwood {

/// The most that a reader takes from a file. What goes beyond is a ParseError, before memory is
/// spent on it.
struct Limits {
    /// Of a file, or of what a packed file holds.
    std::uint64_t max_bytes = std::uint64_t{1} << 38;
    /// Indices are of 32 bits, so that no more than these can be had.
    std::uint64_t max_vertices = (std::uint64_t{1} << 31) - 1;
    std::uint64_t max_faces = (std::uint64_t{1} << 31) - 1;
    /// Of what may lie in one another: JSON values, nodes of a scene, included files.
    std::uint64_t max_depth = 256;
};

}  // namespace boxwood
