// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/validate.h"

#include <fmt/format.h>

#include <vector>

#include "boxwood/tree/parents.h"

namespace boxwood {

namespace {

std::optional<std::string> find_fault_of_parents(const Tree& tree) {
    Tree expected = tree;
    add_parents(expected);
    const auto& parents = expected.parents;
    if (tree.parents.size() != parents.size())
        return fmt::format("{} parents, expected {}", tree.parents.size(), parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (tree.parents[i] != parents[i])
            return fmt::format("node {} has parent {}, expected {}", i, tree.parents[i],
                               parents[i]);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> find_fault(const Tree& tree, std::span<const Box3f> boxes) {
    if (tree.order.size() != boxes.size())
        return fmt::format("{} primitives in the order, expected {}", tree.order.size(),
                           boxes.size());
    if (tree.is_empty()) {
        if (boxes.empty()) return std::nullopt;
        return fmt::format("no nodes over {} primitives", boxes.size());
    }

    std::vector<bool> node_seen(tree.nodes.size());
    std::vector<bool> primitive_seen(boxes.size());
    std::vector<std::uint32_t> stack = {0};
    std::size_t nodes = 0, primitives = 0;
    while (!stack.empty()) {
        const std::uint32_t index = stack.back();
        stack.pop_back();
        if (node_seen[index]) return fmt::format("node {} has two parents", index);
        node_seen[index] = true;
        ++nodes;

        const Node& node = tree.nodes[index];
        Box3f content;
        if (node.is_leaf()) {
            if (std::uint64_t{node.first} + node.count > tree.order.size())
                return fmt::format("leaf {} ends beyond the order", index);
            for (const std::uint32_t primitive : tree.primitives(node)) {
                if (primitive >= boxes.size())
                    return fmt::format("leaf {} holds unknown primitive {}", index, primitive);
                if (primitive_seen[primitive])
                    return fmt::format("primitive {} is in two leaves", primitive);
                primitive_seen[primitive] = true;
                ++primitives;
                content.extend(boxes[primitive]);
            }
        } else {
            if (std::uint64_t{node.first} + 1 >= tree.nodes.size())
                return fmt::format("node {} has children beyond the last node", index);
            for (const std::uint32_t child : {node.left(), node.right()}) {
                content.extend(tree.nodes[child].box);
                stack.push_back(child);
            }
        }
        if (node.box != content) return fmt::format("the box of node {} isn't tight", index);
    }
    if (nodes != tree.nodes.size())
        return fmt::format("{} of {} nodes are reached", nodes, tree.nodes.size());
    if (primitives != boxes.size())
        return fmt::format("{} of {} primitives are in leaves", primitives, boxes.size());
    return find_fault_of_parents(tree);
}

std::optional<std::string> find_fault_in_split_tree(const Tree& tree,
                                                    std::span<const Box3f> boxes) {
    if (tree.is_empty()) {
        if (boxes.empty() && tree.order.empty()) return std::nullopt;
        return fmt::format("no nodes over {} primitives", boxes.size());
    }
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<bool> node_seen(tree.nodes.size()), place_seen(tree.order.size());
    std::vector<std::uint32_t> last_leaf(boxes.size(), kNone);
    std::vector<Box3f> covered(boxes.size());
    std::vector<std::uint32_t> stack = {0};
    std::size_t nodes = 0, places = 0;
    while (!stack.empty()) {
        const std::uint32_t index = stack.back();
        stack.pop_back();
        if (node_seen[index]) return fmt::format("node {} has two parents", index);
        node_seen[index] = true;
        ++nodes;

        const Node& node = tree.nodes[index];
        if (!node.is_leaf()) {
            if (std::uint64_t{node.first} + 1 >= tree.nodes.size())
                return fmt::format("node {} has children beyond the last node", index);
            if (node.box != merged(tree.nodes[node.left()].box, tree.nodes[node.right()].box))
                return fmt::format("the box of node {} isn't tight", index);
            stack.push_back(node.left());
            stack.push_back(node.right());
            continue;
        }
        if (std::uint64_t{node.first} + node.count > tree.order.size())
            return fmt::format("leaf {} ends beyond the order", index);
        Box3f content;
        for (std::uint32_t place = node.first; place < node.first + node.count; ++place) {
            if (place_seen[place])
                return fmt::format("place {} of the order is in two leaves", place);
            place_seen[place] = true;
            ++places;
            const std::uint32_t primitive = tree.order[place];
            if (primitive >= boxes.size())
                return fmt::format("leaf {} holds unknown primitive {}", index, primitive);
            if (last_leaf[primitive] == index)
                return fmt::format("leaf {} holds primitive {} twice", index, primitive);
            last_leaf[primitive] = index;
            const Box3f& box = boxes[primitive];
            content.extend(box);
            covered[primitive].extend(
                Box3f{node.box.lo.cwiseMax(box.lo), node.box.hi.cwiseMin(box.hi)});
        }
        if (!content.contains(node.box))
            return fmt::format("leaf {} is larger than its primitives", index);
    }
    if (nodes != tree.nodes.size())
        return fmt::format("{} of {} nodes are reached", nodes, tree.nodes.size());
    if (places != tree.order.size())
        return fmt::format("{} of {} places of the order are in leaves", places, tree.order.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (last_leaf[i] == kNone) return fmt::format("primitive {} is in no leaf", i);
        if (!covered[i].contains(boxes[i]))
            return fmt::format("primitive {} sticks out of its leaves", i);
    }
    return std::nullopt;
}

}  // namespace boxwood
