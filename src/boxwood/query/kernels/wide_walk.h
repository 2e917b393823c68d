// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Places on the stack of a walk. No tree that is collapsed needs more; see collapse.cpp.
constexpr int kStackSize = 4096;
/// Vectors are stored whole, so there is room for one beyond the end.
constexpr int kStackSlack = 16;

/// The same where many rays have a stack each; trees that need more are walked ray by ray.
constexpr int kWavefrontStack = 256;
/// Fewer rays than this are no faster together.
constexpr std::size_t kFewRays = 8;
/// Trees beyond this many bytes don't stay in the caches, so what comes next is fetched ahead.
constexpr std::size_t kLargeTree = std::size_t{24} << 20;

/// Asks for the memory of a node or block that will be visited soon.
template <int N>
BOXWOOD_KERNEL void prefetch(const WideTreeView& tree, WideReference reference) {
    const std::byte* memory = tree.memory + byte_offset(reference);
    for (std::size_t line = 0; line < sizeof(TriangleBlock<N>); line += 64)
        __builtin_prefetch(memory + line);
}

}  // namespace boxwood
