// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "boxwood/tree/tree.h"

namespace boxwood {

// Where top-down builders put their nodes. A node over the range [begin, end) of the primitives is
// split at a place begin < middle < end, and no other node of the tree is split there. So each
// split owns a pair of slots, known from its place alone: tasks need no shared counter, and the
// array is the same for any number of threads.

constexpr std::uint32_t slot_of_children(std::uint32_t middle) { return 2 * middle - 1; }

/// Ranges of fewer primitives are built by the task that comes to them.
constexpr std::uint32_t kSmallestTask = 2048;

/// Moves the nodes together when leaves of several primitives have left slots empty; an empty slot
/// is a node that no split wrote, other than the root: first == 0 and count == 0.
void close_gaps(std::vector<Node>& nodes);

/// What stands in Tree::order where a builder left room and no leaf took it ...
constexpr std::uint32_t kUnusedPlace = 0xffffffff;
/// ... until this moves the others together.
void close_gaps_in_order(Tree& tree);

}  // namespace boxwood
