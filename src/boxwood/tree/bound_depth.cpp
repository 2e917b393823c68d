// SPDX-License-Identifier: Apache-2.0
#include "boxwood/tree/bound_depth.h"

#include <utility>

namespace boxwood {

namespace {

class DepthBound {
public:
    DepthBound(const Tree& tree, int max_depth) : tree_(tree), max_depth_(max_depth) {
        result_.order = tree.order;
        result_.nodes.resize(1);
    }

    Tree run() && {
        struct Place {
            std::uint32_t from, to;
            int depth;
        };
        std::vector<Place> to_do = {{0, 0, 0}};
        while (!to_do.empty()) {
            const auto [from, to, depth] = to_do.back();
            to_do.pop_back();
            const Node& node = tree_.nodes[from];
            if (node.is_leaf()) {
                result_.nodes[to] = node;
            } else if (depth == max_depth_) {
                const std::vector<std::uint32_t> leaves = leaves_below(from);
                join(leaves.data(), leaves.data() + leaves.size(), to);
            } else {
                const std::uint32_t left = add_children(to, node.box);
                to_do.push_back({node.right(), left + 1, depth + 1});
                to_do.push_back({node.left(), left, depth + 1});
            }
        }
        return std::move(result_);
    }

private:
    std::uint32_t add_children(std::uint32_t parent, const Box3f& box) {
        const auto left = static_cast<std::uint32_t>(result_.nodes.size());
        result_.nodes.resize(left + 2);
        result_.nodes[parent] = {box, left, 0};
        return left;
    }

    std::vector<std::uint32_t> leaves_below(std::uint32_t root) const {
        std::vector<std::uint32_t> leaves, to_do = {root};
        while (!to_do.empty()) {
            const std::uint32_t index = to_do.back();
            to_do.pop_back();
            if (tree_.nodes[index].is_leaf()) {
                leaves.push_back(index);
            } else {
                to_do.push_back(tree_.nodes[index].right());
                to_do.push_back(tree_.nodes[index].left());
            }
        }
        return leaves;
    }

    void join(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t to) {
        if (end - begin == 1) {
            result_.nodes[to] = tree_.nodes[*begin];
            return;
        }
        const std::uint32_t left = add_children(to, {});
        const std::uint32_t* middle = begin + (end - begin + 1) / 2;
        join(begin, middle, left);
        join(middle, end, left + 1);
        result_.nodes[to].box = merged(result_.nodes[left].box, result_.nodes[left + 1].box);
    }

    const Tree& tree_;
    int max_depth_;
    Tree result_;
};

}  // namespace

Tree bound_depth(const Tree& tree, int max_depth) {
    if (tree.is_empty()) return {};
    return DepthBound(tree, max_depth).run();
}

}  // namespace boxwood
