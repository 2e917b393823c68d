// SPDX-License-Identifier: Apache-2.0
#include "boxwood/build/merge_tree.h"

#include "boxwood/build/slots.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

class MergeTreeWriter {
public:
    MergeTreeWriter(std::span<const Box3f> boxes, std::span<const std::uint32_t> order,
                    std::span<const Merge> merges)
        : boxes_(boxes), order_(order), merges_(merges) {
        tree_.nodes.resize(nodes(root()));
        tree_.order.resize(boxes.size());
    }

    Tree write() && {
        write_node(root(), {.node = 0, .below = 1, .primitives = 0});
        return std::move(tree_);
    }

private:
    /// Where in the tree a subtree goes: sizes are known, so tasks need no shared counter.
    struct Place {
        std::uint32_t node;        ///< its root
        std::uint32_t below;       ///< the first of its other nodes
        std::uint32_t primitives;  ///< the first in the order
    };

    std::uint32_t root() const {
        return static_cast<std::uint32_t>(boxes_.size() + merges_.size() - 1);
    }
    bool is_primitive(std::uint32_t name) const { return name < boxes_.size(); }
    const Merge& merge(std::uint32_t name) const { return merges_[name - boxes_.size()]; }
    std::uint32_t count(std::uint32_t name) const {
        return is_primitive(name) ? 1 : merge(name).count;
    }
    std::uint32_t nodes(std::uint32_t name) const {
        return is_primitive(name) ? 1 : merge(name).nodes;
    }

    void write_node(std::uint32_t name, const Place& place) {
        Node& node = tree_.nodes[place.node];
        if (nodes(name) == 1) {
            node.first = place.primitives;
            std::uint32_t end = place.primitives;
            add_primitives(name, node.box, end);
            node.count = end - node.first;
            return;
        }
        const auto [left, right, primitives, unused] = merge(name);
        node.first = place.below;
        const std::uint32_t below_left = place.below + 2;
        const Place left_place = {node.left(), below_left, place.primitives};
        const Place right_place = {node.right(), below_left + nodes(left) - 1,
                                   place.primitives + count(left)};
        invoke_both(
            primitives > kSmallestTask, [&, part = left] { write_node(part, left_place); },
            [&, part = right] { write_node(part, right_place); });
        node.box = merged(tree_.nodes[node.left()].box, tree_.nodes[node.right()].box);
    }

    void add_primitives(std::uint32_t name, Box3f& box, std::uint32_t& end) {
        if (is_primitive(name)) {
            tree_.order[end++] = order_[name];
            box.extend(boxes_[order_[name]]);
        } else {
            add_primitives(merge(name).left, box, end);
            add_primitives(merge(name).right, box, end);
        }
    }

    std::span<const Box3f> boxes_;
    std::span<const std::uint32_t> order_;
    std::span<const Merge> merges_;
    Tree tree_;
};

}  // namespace

Tree make_merge_tree(std::span<const Box3f> boxes, std::span<const std::uint32_t> order,
                     std::span<const Merge> merges) {
    if (boxes.empty()) return {};
    return MergeTreeWriter(boxes, order, merges).write();
}

}  // namespace boxwood
