// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/parts.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "boxwood/core/huge_pages.h"

namespace boxwood {

namespace {

std::size_t node_count(const TreePart& part) {
    return part.nodes.size() +
           (part.left ? node_count(*part.left) + node_count(*part.right) : std::size_t{0});
}

/// The root goes to its index, what is below it to the next place and behind it.
void put(const TreePart& part, std::vector<Node>& nodes, std::uint32_t index, std::uint32_t& next) {
    const std::uint32_t first = next;
    if (part.left) {
        nodes[index] = part.nodes[0];
        nodes[index].first = first;
        next += 2;
        put(*part.left, nodes, first, next);
        put(*part.right, nodes, first + 1, next);
        return;
    }
    const auto moved = [offset = first - 1](Node node) {
        if (!node.is_leaf()) node.first += offset;
        return node;
    };
    nodes[index] = moved(part.nodes[0]);
    std::transform(part.nodes.begin() + 1, part.nodes.end(), nodes.begin() + first, moved);
    next += static_cast<std::uint32_t>(part.nodes.size() - 1);
}

}  // namespace

std::vector<Node> joined(TreePart part) {
    if (!part.left) return std::move(part.nodes);
    std::vector<Node> nodes;
    resize_on_huge_pages(nodes, node_count(part));
    std::uint32_t next = 1;
    put(part, nodes, 0, next);
    return nodes;
}

}  // namespace boxwood
