// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/core/box.h"

namespace boxwood {

/// A primitive in its lower half, in the upper one the Morton code of the cell that its centroid is
/// in. The cells come from halving a cube along x, y and z in turn, ten times each; the code tells
/// the side of each cut, of the first in its highest bit. In the order of their codes, cells that
/// follow each other are near each other.
using MortonKey = std::uint64_t;

constexpr int kMortonBits = 30;

constexpr MortonKey morton_key(std::uint32_t code, std::uint32_t primitive) {
    return MortonKey{code} << 32 | primitive;
}
constexpr std::uint32_t code_of(MortonKey key) { return static_cast<std::uint32_t>(key >> 32); }
constexpr std::uint32_t primitive_of(MortonKey key) { return static_cast<std::uint32_t>(key); }

/// One key a primitive, in order and without a code.
void number_primitives(std::span<MortonKey> keys);

/// Gives the primitives of the keys codes within the cube around their centroids, and sorts by
/// code; equal codes stay in order. Boxes that nothing hits come first. O(n), all cores.
/// Precondition: scratch is as large as keys.
void sort_by_morton_code(std::span<const Box3f> boxes, std::span<MortonKey> keys,
                         std::span<MortonKey> scratch);

/// The same, and cells of many primitives are cut into cells of their own, however small: the order
/// is as good when one far away would otherwise push all others into one cell. The codes are of no
/// use afterwards.
void sort_along_curve(std::span<const Box3f> boxes, std::span<MortonKey> keys,
                      std::span<MortonKey> scratch);

}  // namespace boxwood
