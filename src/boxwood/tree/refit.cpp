// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/refit.h"

#include <vector>

namespace boxwood {

void refit(Tree& tree, std::span<const Box3f> boxes) {
    if (tree.is_empty()) return;
    // Each node before those below it.
    std::vector<std::uint32_t> order = {0};
    order.reserve(tree.nodes.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Node& node = tree.nodes[order[i]];
        if (!node.is_leaf()) order.insert(order.end(), {node.left(), node.right()});
    }
    for (std::size_t i = order.size(); i-- > 0;) {
        Node& node = tree.nodes[order[i]];
        node.box = {};
        if (node.is_leaf()) {
            for (const std::uint32_t primitive : tree.primitives(node))
                node.box.extend(boxes[primitive]);
        } else {
            node.box = merged(tree.nodes[node.left()].box, tree.nodes[node.right()].box);
        }
    }
}

}  // namespace boxwood
