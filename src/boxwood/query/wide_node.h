// SPDX-License-Identifier: Apache-2.0
// How a wide tree lies in memory. A node holds the boxes of its N children side by side, so that
// one instruction compares a ray with all of them; a leaf is a block of up to N triangles, laid out
// likewise. Explained in docs/algorithms/wide_tree.md.
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/core/simd.h"

namespace boxwood {

/// Where a node or a block is: its distance from the start of the tree in units of kReferenceUnit
/// bytes, and whether it is a leaf.
using WideReference = std::uint32_t;
constexpr WideReference kLeafBit = 0x80000000u;
constexpr std::size_t kReferenceUnit = 32;

BOXWOOD_KERNEL constexpr bool is_leaf(WideReference reference) {
    return (reference & kLeafBit) != 0;
}
BOXWOOD_KERNEL constexpr std::size_t byte_offset(WideReference reference) {
    return std::size_t{reference & ~kLeafBit} * kReferenceUnit;
}

/// An inner node. Children stand in the order that their surface areas had when the tree was built,
/// the largest last: a ray that looks for any hit tries that first. Slots without a child have a
/// box that nothing hits.
template <int N>
struct alignas(4 * N) WideNode {
    struct Slab {
        float lo[N], hi[N];
    };
    Slab slabs[3];           ///< along x, y and z
    WideReference child[N];  ///< 0 in an empty slot
    /// Slots by their distance along a ray of each octant of directions, the farthest first and
    /// empty ones last: the k-th of octant o is in bits 4 o to 4 o + 3 of the k-th number.
    std::uint32_t order[N];
};

/// A leaf: up to N triangles in the order of their indices. Empty slots have NaN corners and the
/// index Hitf::kNone; triangles that moved to where nothing is finite have NaN corners as well.
template <int N>
struct alignas(4 * N) TriangleBlock {
    float corner[3][3][N];  ///< [a, b, c][x, y, z]
    std::uint32_t triangle[N];
};

/// A leaf of a compact tree: the same with each vertex once. What is in empty slots is a NaN.
template <int N>
struct alignas(4 * N) CompactBlock {
    std::uint32_t triangle[N];
    std::uint8_t corner[3][N];  ///< which of the vertices
    /// Three floats each, from the end of these arrays on.
    BOXWOOD_KERNEL const float* vertices() const {
        return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(this) + 7 * N);
    }
    BOXWOOD_KERNEL float* vertices() {
        return reinterpret_cast<float*>(reinterpret_cast<std::byte*>(this) + 7 * N);
    }
};

/// A wide tree as kernels see it. The root is at the start of the memory.
struct WideTreeView {
    const std::byte* memory = nullptr;
    std::size_t bytes = 0;
    bool is_compact = false;       ///< leaves are compact blocks
    int stack_size = 0;            ///< places that a walk needs at most to remember nodes
    float lo[4] = {}, hi[4] = {};  ///< the bounds; the fourth number is idle

    template <int N>
    BOXWOOD_KERNEL const WideNode<N>& node(WideReference reference) const {
        return *reinterpret_cast<const WideNode<N>*>(memory + byte_offset(reference));
    }
};

static_assert(sizeof(WideNode<4>) % kReferenceUnit == 0);
static_assert(sizeof(TriangleBlock<4>) % kReferenceUnit == 0);

}  // namespace boxwood
