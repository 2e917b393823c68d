// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/statistics.h"

#include <algorithm>

namespace boxwood {

std::vector<std::uint32_t> node_depths(const Tree& tree) {
    std::vector<std::uint32_t> depths(tree.nodes.size(), 0);
    std::vector<std::uint32_t> stack;
    if (!tree.is_empty()) stack.push_back(0);
    while (!stack.empty()) {
        const std::uint32_t index = stack.back();
        stack.pop_back();
        const Node& node = tree.nodes[index];
        if (node.is_leaf()) continue;
        for (const std::uint32_t child : {node.left(), node.right()}) {
            depths[child] = depths[index] + 1;
            stack.push_back(child);
        }
    }
    return depths;
}

TreeStatistics statistics(const Tree& tree) {
    TreeStatistics result;
    result.nodes = tree.nodes.size();
    result.bytes = tree.nodes.size() * sizeof(Node) +
                   (tree.order.size() + tree.parents.size()) * sizeof(std::uint32_t);
    if (tree.is_empty()) return result;

    const std::vector<std::uint32_t> depths = node_depths(tree);
    double area_times_cost = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const Node& node = tree.nodes[i];
        area_times_cost += node.box.surface_area() * (node.is_leaf() ? node.count : 1);
        if (!node.is_leaf()) continue;
        ++result.leaves;
        result.depth = std::max<std::size_t>(result.depth, depths[i]);
        result.largest_leaf = std::max<std::size_t>(result.largest_leaf, node.count);
    }
    const double root_area = tree.root().box.surface_area();
    result.sah_cost = root_area > 0 ? area_times_cost / root_area : 0;
    return result;
}

}  // namespace boxwood
