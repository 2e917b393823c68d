// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/parents.h"

#include <utility>

namespace boxwood {

namespace {

bool is_deep(const Tree& tree) {
    if (tree.is_empty()) return false;
    std::vector<std::pair<std::uint32_t, std::size_t>> to_do = {{0, 0}};
    while (!to_do.empty()) {
        const auto [index, depth] = to_do.back();
        to_do.pop_back();
        if (depth > kDeepestWithoutParents) return true;
        const Node& node = tree.nodes[index];
        if (node.is_leaf()) continue;
        to_do.emplace_back(node.left(), depth + 1);
        to_do.emplace_back(node.right(), depth + 1);
    }
    return false;
}

}  // namespace

void add_parents(Tree& tree) {
    tree.parents.clear();
    if (!is_deep(tree)) return;
    tree.parents.resize(tree.nodes.size());
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
        const Node& node = tree.nodes[i];
        if (!node.is_leaf()) tree.parents[node.left()] = tree.parents[node.right()] = i;
    }
}

}  // namespace boxwood
