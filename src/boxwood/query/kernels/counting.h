// SPDX-License-Identifier: Apache-2.0
// Counting what a walk does. A kernel takes a pack of counts and tells of each visit with it. The
// pack is empty in the kernels that everybody runs, which leaves nothing in their machine code: the
// first of each pair of functions below. With WideCounts in it, the second adds to them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/query/rayf.h"
#include "boxwood/query/wide_counts.h"
#include "boxwood/query/wide_node.h"

namespace boxwood {

/// The cache lines that the bytes from there on lie in.
BOXWOOD_KERNEL std::uint64_t lines_of(const void* first, std::size_t bytes) {
    constexpr std::uintptr_t kLine = 64;
    const auto begin = reinterpret_cast<std::uintptr_t>(first);
    return (begin + bytes - 1) / kLine - begin / kLine + 1;
}

/// A visit to a node that reads its boxes and, if so, where its children are and their order.
template <int N>
BOXWOOD_KERNEL void count_node(const WideNode<N>&, bool, bool) {}
template <int N>
BOXWOOD_KERNEL void count_node(const WideNode<N>& node, bool reads_children, bool reads_order,
                               WideCounts& counts) {
    ++counts.nodes;
    for (int i = 0; i < N; ++i) counts.boxes += node.child[i] != 0;
    std::size_t bytes = offsetof(WideNode<N>, child);
    if (reads_children) bytes = offsetof(WideNode<N>, order);
    if (reads_order) bytes = sizeof node;
    counts.lines += lines_of(&node, bytes);
}

/// A visit to a block that reads its corners and, if so, which triangles they are of. Compact
/// blocks are read whole.
template <int N>
BOXWOOD_KERNEL void count_block(const WideTreeView&, WideReference, bool) {}
template <int N>
BOXWOOD_KERNEL void count_block(const WideTreeView& tree, WideReference reference,
                                bool reads_indices, WideCounts& counts) {
    const std::byte* place = tree.memory + byte_offset(reference);
    const std::uint32_t* triangles = nullptr;
    std::size_t bytes = 0;
    if (tree.is_compact) {
        const auto& block = *reinterpret_cast<const CompactBlock<N>*>(place);
        triangles = block.triangle;
        std::size_t vertices = 0;
        for (const auto& corners : block.corner) {
            for (const std::size_t vertex : corners)
                if (vertex >= vertices) vertices = vertex + 1;
        }
        const auto* end = reinterpret_cast<const std::byte*>(block.vertices() + 3 * vertices);
        bytes = static_cast<std::size_t>(end - place);
    } else {
        const auto& block = *reinterpret_cast<const TriangleBlock<N>*>(place);
        triangles = block.triangle;
        bytes = reads_indices ? sizeof block : offsetof(TriangleBlock<N>, triangle);
    }
    ++counts.blocks;
    for (int i = 0; i < N; ++i) counts.triangles += triangles[i] != Hitf::kNone;
    counts.lines += lines_of(place, bytes);
}

}  // namespace boxwood
