// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/slots.h"

#include <vector>

namespace boxwood {

void close_gaps(std::vector<Node>& nodes) {
    const auto is_used = [&](std::size_t i) {
        return i == 0 || nodes[i].is_leaf() || nodes[i].first > 0;
    };
    std::vector<std::uint32_t> new_index(nodes.size());
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        new_index[i] = used;
        if (is_used(i)) ++used;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!is_used(i)) continue;
        Node& node = nodes[new_index[i]];
        node = nodes[i];
        if (!node.is_leaf()) node.first = new_index[node.first];
    }
    nodes.resize(used);
    nodes.shrink_to_fit();
}

void close_gaps_in_order(Tree& tree) {
    std::vector<std::uint32_t> new_place(tree.order.size());
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < tree.order.size(); ++i) {
        new_place[i] = used;
        if (tree.order[i] != kUnusedPlace) tree.order[used++] = tree.order[i];
    }
    tree.order.resize(used);
    tree.order.shrink_to_fit();
    for (Node& node : tree.nodes) {
        if (node.is_leaf()) node.first = new_place[node.first];
    }
}

}  // namespace boxwood
