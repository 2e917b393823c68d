// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "boxwood/query/wide_node.h"

namespace boxwood {

/// Trees are no deeper than this, in nodes.
constexpr int kDeepestWideTree = 160;

/// Where the children of a node end, in units of kReferenceUnit. They follow their node without
/// gaps: first the leaves, then the subtrees, both in the order of their slots; the last one ends
/// where the node's own subtree does.
template <int N>
class ChildEnds {
public:
    ChildEnds(const WideNode<N>& node, std::uint32_t end) : first_(end) {
        for (const bool leaves : {false, true}) {
            for (int i = N - 1; i >= 0; --i) {
                if (node.child[i] == 0 || is_leaf(node.child[i]) != leaves) continue;
                end_[i] = first_;
                first_ = node.child[i] & ~kLeafBit;
            }
        }
    }

    /// Precondition: the slot has a child.
    std::uint32_t operator[](int slot) const { return end_[slot]; }
    /// Where the first child begins, which is where the node ends.
    std::uint32_t first() const { return first_; }

private:
    std::array<std::uint32_t, N> end_;
    std::uint32_t first_;
};

}  // namespace boxwood
