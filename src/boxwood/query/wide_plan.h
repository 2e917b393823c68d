// SPDX-License-Identifier: Apache-2.0
// A wide node stands for the top of a binary subtree; which top is best, and where leaves begin, is
// found by dynamic programming: with at most i places in its parent a subtree costs
//   cost(i) = min(cost(i - 1), min over k of left.cost(k) + right.cost(i - k)),
//   cost(1) = min(as a leaf, as a node: its own visit + min over k of left(k) + right(N - k)),
// where a visit is weighed by the chance that a ray makes it, the surface area. Sources: Wald et
// al., "Getting Rid of Packets", 2008; Ylitie et al., "Efficient Incoherent Ray Traversal on GPUs
// Through Compressed Wide BVHs", HPG 2017. See docs/algorithms/wide_tree.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_cost.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// Which nodes of a binary tree become nodes of up to N children, and which blocks of up to N
/// triangles: the cheapest choice.
template <int N>
class WidePlan {
public:
    /// Deeper trees aren't planned, which bounds the stack of a walk: (kDeepest + 32) * 15 places
    /// are less than kStackSize.
    static constexpr int kDeepest = 120;

    /// Precondition: the tree isn't empty.
    explicit WidePlan(const Tree& tree)
        : tree_(tree),
          rows_memory_(tree.nodes.size() * sizeof(Row)),
          states_memory_(tree.nodes.size() * sizeof(State)),
          rows_(reinterpret_cast<Row*>(rows_memory_.data())),
          states_(reinterpret_cast<State*>(states_memory_.data())) {
        const double area = tree.root().box.surface_area();
        inverse_area_ = area > 0 ? 1 / area : 0;
    }

    /// False when the tree is too deep. Throws InvalidInput on leaves of more than a block.
    bool make() { return plan(0, 0); }

    /// Of the tree. The root is a node, whatever is cheaper.
    double cost() const {
        return cost(0, 1) + (states_[0].is_leaf && inverse_area_ > 0 ? kNodeCost : 0);
    }

    bool is_leaf(std::uint32_t index) const { return states_[index].is_leaf; }
    std::uint32_t triangles(std::uint32_t index) const { return states_[index].triangles; }

    /// Chooses the children of the wide node that stands for this one, by their area, and calls
    /// leave_out(index) for what nothing hits and needs no place. Afterwards nobody may ask for the
    /// children of a node above it. The root is a node even when all of the tree fits into a block,
    /// which then is its child.
    template <class LeaveOut>
    void choose_children(std::uint32_t index, const LeaveOut& leave_out) {
        Children opened;
        if (states_[index].is_leaf) {
            opened.add(index);
        } else {
            share(index, states_[index].places, opened);
        }
        Children children;
        std::array<float, N> areas;
        for (int i = 0; i < opened.count; ++i) {
            const std::uint32_t child = opened.node[i];
            if (tree_.nodes[child].box.is_empty()) {
                leave_out(child);
                continue;
            }
            const float area = relative_area(tree_.nodes[child]);
            int place = children.count++;
            for (; place > 0 && areas[place - 1] > area; --place) {
                areas[place] = areas[place - 1];
                children.node[place] = children.node[place - 1];
            }
            areas[place] = area;
            children.node[place] = child;
        }
        std::copy_n(children.node.begin(), children.count, rows_[index].children);
        states_[index].children = static_cast<std::uint8_t>(children.count);
    }

    /// Precondition: they were chosen.
    std::span<const std::uint32_t> children(std::uint32_t index) const {
        return {rows_[index].children, states_[index].children};
    }

private:
    /// Where one block will do, several have to bring the cost down to this share: memory costs as
    /// well.
    static constexpr float kWorthMoreBlocks = 0.75f;
    /// What is below this depth is planned by the task that comes to it.
    static constexpr int kTaskDepth = 8;

    /// What is known of a binary node: first the costs of its subtree, later, where a wide node
    /// stands for it, the children of that.
    union Row {
        float costs[N];  ///< with up to i + 1 places
        std::uint32_t children[N];
    };

    struct State {
        std::uint32_t triangles;
        std::uint8_t children;  ///< once they are chosen
        std::uint8_t places;    ///< that it can use at most
        bool is_leaf;
    };

    struct Children {
        std::array<std::uint32_t, N> node;
        int count = 0;

        void add(std::uint32_t child) { node[count++] = child; }
    };

    float relative_area(const Node& node) const {
        return static_cast<float>(node.box.surface_area() * inverse_area_);
    }

    float cost(std::uint32_t index, int places) const { return rows_[index].costs[places - 1]; }

    /// Fills states and rows from the leaves up; false where it is too deep.
    bool plan(std::uint32_t index, int depth) {
        const Node& node = tree_.nodes[index];
        if (node.is_leaf()) {
            if (node.count > N)
                throw InvalidInput("WideTree: a leaf of the tree has more triangles than a block");
            states_[index] = {node.count, 0, 1, true};
            rows_[index].costs[0] = relative_area(node) * kBlockCost;
            return true;
        }
        if (depth == kDeepest) return false;
        bool left_done = false, right_done = false;
        invoke_both(
            depth < kTaskDepth, [&] { left_done = plan(node.left(), depth + 1); },
            [&] { right_done = plan(node.right(), depth + 1); });
        if (left_done && right_done) plan_from_children(index);
        return left_done && right_done;
    }

    void plan_from_children(std::uint32_t index) {
        const Node& node = tree_.nodes[index];
        const State& left = states_[node.left()];
        const State& right = states_[node.right()];
        int places = std::min(left.places + right.places, N);
        std::array<float, N + 1> shared;
        std::fill(shared.begin(), shared.begin() + places + 1,
                  std::numeric_limits<float>::infinity());
        for (int k = 1; k <= left.places; ++k) {
            const float left_cost = cost(node.left(), k);
            const int last = std::min<int>(right.places, N - k);
            for (int i = 1; i <= last; ++i)
                shared[k + i] = std::min(shared[k + i], left_cost + cost(node.right(), i));
        }
        const float area = relative_area(node);
        const std::uint32_t count = left.triangles + right.triangles;
        const float as_node = area * kNodeCost + shared[places];
        const float as_leaf =
            count <= N ? area * kBlockCost : std::numeric_limits<float>::infinity();
        const bool is_leaf = as_leaf <= as_node;
        if (is_leaf && shared[places] > kWorthMoreBlocks * as_leaf) places = 1;
        states_[index] = {count, 0, static_cast<std::uint8_t>(places), is_leaf};
        float best = std::min(as_leaf, as_node);
        rows_[index].costs[0] = best;
        for (int i = 2; i <= places; ++i)
            rows_[index].costs[i - 1] = best = std::min(best, shared[i]);
    }

    /// Shares places among what is below the node.
    void share(std::uint32_t index, int places, Children& children) const {
        const std::uint32_t left = tree_.nodes[index].left();
        const std::uint32_t right = tree_.nodes[index].right();
        const int first = std::max(1, places - states_[right].places);
        const int last = std::min<int>(states_[left].places, places - 1);
        int best = first;
        float least = std::numeric_limits<float>::infinity();
        for (int k = first; k <= last; ++k) {
            const float sum = cost(left, k) + cost(right, places - k);
            if (sum < least) {
                least = sum;
                best = k;
            }
        }
        place(left, best, children);
        place(right, places - best, children);
    }

    void place(std::uint32_t index, int places, Children& children) const {
        while (places > 1 && cost(index, places) == cost(index, places - 1)) --places;
        if (places == 1) {
            children.add(index);
        } else {
            share(index, places, children);
        }
    }

    const Tree& tree_;
    Arena rows_memory_, states_memory_;
    Row* rows_;
    State* states_;
    double inverse_area_;
};

}  // namespace boxwood
