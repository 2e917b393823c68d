// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/parents.h"

#include "boxwood/tree/statistics.h"

namespace boxwood {

void add_parents(Tree& tree) {
    tree.parents.clear();
    if (statistics(tree).depth <= kDeepestWithoutParents) return;
    tree.parents.resize(tree.nodes.size());
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
        const Node& node = tree.nodes[i];
        if (!node.is_leaf()) tree.parents[node.left()] = tree.parents[node.right()] = i;
    }
}

}  // namespace boxwood
