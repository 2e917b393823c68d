// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/statistics.h"

#include <algorithm>
#include <utility>

namespace boxwood {

TreeStatistics statistics(const Tree& tree) {
    TreeStatistics result;
    result.nodes = tree.nodes.size();
    result.bytes = tree.nodes.size() * sizeof(Node) +
                   (tree.order.size() + tree.parents.size()) * sizeof(std::uint32_t);
    if (tree.is_empty()) return result;

    double area_times_cost = 0;
    std::vector<std::pair<std::uint32_t, std::size_t>> stack = {{0, 0}};
    while (!stack.empty()) {
        const auto [index, depth] = stack.back();
        stack.pop_back();
        const Node& node = tree.nodes[index];
        area_times_cost += node.box.surface_area() * (node.is_leaf() ? node.count : 1);
        if (node.is_leaf()) {
            ++result.leaves;
            result.depth = std::max(result.depth, depth);
            result.largest_leaf = std::max<std::size_t>(result.largest_leaf, node.count);
        } else {
            stack.emplace_back(node.left(), depth + 1);
            stack.emplace_back(node.right(), depth + 1);
        }
    }
    const double root_area = tree.root().box.surface_area();
    result.sah_cost = root_area > 0 ? area_times_cost / root_area : 0;
    return result;
}

}  // namespace boxwood
