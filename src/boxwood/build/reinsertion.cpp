// SPDX-License-Identifier: Apache-2.0
// A tree that was built top-down has made its first cuts knowing the least. Taking a subtree out
// and putting it back elsewhere repairs them one by one: its parent goes, its sibling moves up, and
// a new parent joins it to the node beside which it costs the least, found by branch and bound.
// Each round finds the best moves of many subtrees in the tree as it is, all at once, and then
// makes those that don't get in each other's way, the most gainful first. Sources: Bittner, Hapala
// and Havran, "Fast Insertion-Based Optimization of Bounding Volume Hierarchies", Computer Graphics
// Forum 32(1), 2013; Meister and Bittner, "Parallel Reinsertion for Bounding Volume Hierarchy
// Optimization", Computer Graphics Forum 37(2), 2018. Explained in docs/algorithms/reinsertion.md.
#include "boxwood/build/reinsertion.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "boxwood/build/sah.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/tree/parents.h"

namespace boxwood {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;
constexpr std::uint32_t kMostDepth = 80;
/// Down to it subtrees are tasks.
constexpr int kTaskDepth = 8;
/// Of the candidates, for a task.
constexpr std::size_t kPiece = 256;

/// Children stand side by side, the left one at an odd place, as the root has place 0.
constexpr std::uint32_t sibling(std::uint32_t node) { return node % 2 ? node + 1 : node - 1; }
constexpr std::uint32_t pair_of(std::uint32_t node) { return (node - 1) / 2; }

struct Move {
    float gain = 0;
    std::uint32_t node = kNone;    ///< what is taken out ...
    std::uint32_t target = kNone;  ///< ... and put back as its sibling
};

/// What is known of the subtree at a place.
struct Subtree {
    Node root;
    std::uint32_t height;
    float area;
};

WideBox wide(const Node& node) {
    WideBox box;
    box.lo << node.box.lo.array(), 0;
    box.hi << node.box.hi.array(), 0;
    return box;
}

class Optimizer {
public:
    Optimizer(Tree& tree, const ReinsertionOptions& options)
        : nodes_(tree.nodes),
          options_(options),
          sah_(unit_scale({&tree.root().box, 1}), 0),
          parents_(nodes_.size() / 2),
          heights_(nodes_.size()),
          areas_(nodes_.size()) {}

    void run();

private:
    friend class Search;
    std::uint32_t parent(std::uint32_t node) const { return parents_[pair_of(node)]; }

    /// Makes boxes, areas and heights of a subtree's inner nodes right. Gives the sum of its inner
    /// areas.
    double refit(std::uint32_t root, int depth = 0);
    std::vector<std::uint32_t> candidates() const;
    std::vector<Move> best_moves(const std::vector<std::uint32_t>& candidates) const;
    void make(const std::vector<Move>& moves);
    bool keeps_tree(const Move& move) const;
    void make(const Move& move);
    Subtree at(std::uint32_t place) const {
        return {nodes_[place], heights_[place], areas_[place]};
    }
    void put(std::uint32_t place, const Subtree& subtree);

    std::vector<Node>& nodes_;
    ReinsertionOptions options_;
    Sah sah_;
    std::vector<std::uint32_t> parents_;  ///< by pair of children
    std::vector<std::uint32_t> heights_;  ///< of the subtrees
    std::vector<float> areas_;
    std::uint32_t most_depth_ = kMostDepth;
};

/// The search for the best place of one subtree.
class Search {
public:
    /// A node to look below, and what is saved less what the boxes down to it grow by.
    struct Entry {
        float saved;
        std::uint32_t node;
    };

    /// The vector is room to work in.
    Search(const Optimizer& tree, std::uint32_t node, std::vector<Entry>& waiting)
        : tree_(tree), box_(wide(tree.nodes_[node])), area_(tree.areas_[node]), waiting_(waiting) {
        best_.node = node;
        // Gains that are nothing but rounding, or nearly, aren't worth a move.
        best_.gain = 1e-4f * tree.areas_[tree.parent(node)];
    }

    /// Goes up from the parent, and at each step down into the other child. `saved` is what taking
    /// the node out saves below there: the parent's area, and what the others get smaller by.
    Move run() {
        const std::uint32_t parent = tree_.parent(best_.node), other = sibling(best_.node);
        float saved = tree_.areas_[parent];
        WideBox without = wide(tree_.nodes_[other]);
        // To become the sibling of the sibling is no move; below it may be one.
        look_below({tree_.areas_[other], other});
        for (std::uint32_t i = parent; i != 0;) {
            const std::uint32_t beside = sibling(i);
            if (const auto below = look_at(beside, saved); below.saved - area_ > best_.gain)
                look_below(below);
            without.extend(wide(tree_.nodes_[beside]));
            i = tree_.parent(i);
            // As the sibling of a node that it was below, in a new parent as large as that was.
            const float area = tree_.sah_.half_area(without);
            consider(i, saved - area);
            saved += tree_.areas_[i] - area;
        }
        return best_;
    }

private:
    void consider(std::uint32_t target, float gain) {
        if (gain > best_.gain) {
            best_.gain = gain;
            best_.target = target;
        }
    }

    Entry look_at(std::uint32_t node, float saved) {
        const float gain = saved - tree_.sah_.half_area(merged(wide(tree_.nodes_[node]), box_));
        consider(node, gain);
        return {gain + tree_.areas_[node], node};
    }

    /// A new parent has at least the node's own area, so what is saved must be more than that.
    void look_below(Entry entry) {
        for (;;) {
            const Node& node = tree_.nodes_[entry.node];
            if (entry.saved - area_ > best_.gain && !node.is_leaf()) {
                Entry near = look_at(node.left(), entry.saved);
                Entry far = look_at(node.right(), entry.saved);
                if (near.saved < far.saved) std::swap(near, far);
                if (far.saved - area_ > best_.gain) waiting_.push_back(far);
                entry = near;
                continue;
            }
            if (waiting_.empty()) return;
            entry = waiting_.back();
            waiting_.pop_back();
        }
    }

    const Optimizer& tree_;
    WideBox box_;
    float area_;
    Move best_;
    std::vector<Entry>& waiting_;
};

void Optimizer::run() {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].is_leaf()) {
            areas_[i] = sah_.half_area(wide(nodes_[i]));
        } else {
            parents_[pair_of(nodes_[i].left())] = i;
        }
    }
    double cost = refit(0);
    most_depth_ = std::max(heights_[0], kMostDepth);
    std::vector<Node> before;
    for (int round = 0; round < options_.rounds; ++round) {
        before = nodes_;
        make(best_moves(candidates()));
        const double new_cost = refit(0);
        // Each move gains by itself; together they may lose, if seldom.
        if (new_cost > cost) nodes_ = before;
        if (!(cost - new_cost > options_.least_gain * cost)) break;
        cost = new_cost;
    }
}

double Optimizer::refit(std::uint32_t root, int depth) {
    if (nodes_[root].is_leaf()) return 0;
    const auto refit_node = [&](std::uint32_t index) {
        Node& node = nodes_[index];
        const std::uint32_t left = node.left(), right = node.right();
        const WideBox box = merged(wide(nodes_[left]), wide(nodes_[right]));
        node.box = box.box();
        areas_[index] = sah_.half_area(box);
        heights_[index] = 1 + std::max(heights_[left], heights_[right]);
        return static_cast<double>(areas_[index]);
    };
    if (depth < kTaskDepth) {
        double left = 0, right = 0;
        invoke_both(
            true, [&] { left = refit(nodes_[root].left(), depth + 1); },
            [&] { right = refit(nodes_[root].right(), depth + 1); });
        return left + right + refit_node(root);
    }
    // Parents stand before their children in this list; no recursion, as trees may be deep.
    std::vector<std::uint32_t> below = {root};
    for (std::size_t i = 0; i < below.size(); ++i) {
        const Node& node = nodes_[below[i]];
        for (const std::uint32_t child : {node.left(), node.right()}) {
            if (!nodes_[child].is_leaf()) below.push_back(child);
        }
    }
    double sum = 0;
    for (std::size_t i = below.size(); i-- > 0;) sum += refit_node(below[i]);
    return sum;
}

/// The nodes with the largest areas, about so many as asked for: the limit comes from a sample.
std::vector<std::uint32_t> Optimizer::candidates() const {
    constexpr std::size_t kStride = 16;
    std::vector<float> sample;
    const std::size_t stride = nodes_.size() < 100 * kStride ? 1 : kStride;
    for (std::size_t i = 1; i < areas_.size(); i += stride) sample.push_back(areas_[i]);
    const auto rank =
        static_cast<std::size_t>(options_.largest_part * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(rank),
                     sample.end(), std::greater<>());
    const float least = sample[rank];
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 1; i < areas_.size(); ++i) {
        if (areas_[i] >= least && areas_[i] > 0) result.push_back(i);
    }
    return result;
}

std::vector<Move> Optimizer::best_moves(const std::vector<std::uint32_t>& candidates) const {
    std::vector<Move> moves(candidates.size());
    parallel_for(candidates.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        std::vector<Search::Entry> waiting;
        for (std::size_t i = begin; i < end; ++i)
            moves[i] = Search(*this, candidates[i], waiting).run();
    });
    std::erase_if(moves, [](const Move& move) { return move.target == kNone; });
    std::sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) {
        return a.gain != b.gain ? a.gain > b.gain : a.node < b.node;
    });
    return moves;
}

/// Makes each move that touches no place that another one has touched.
void Optimizer::make(const std::vector<Move>& moves) {
    std::vector<bool> is_touched(nodes_.size());
    for (const Move& move : moves) {
        const std::array<std::uint32_t, 4> places = {move.node, sibling(move.node),
                                                     parent(move.node), move.target};
        const auto touched = [&](std::uint32_t place) { return is_touched[place]; };
        if (std::any_of(places.begin(), places.end(), touched) || !keeps_tree(move)) continue;
        for (const std::uint32_t place : places) is_touched[place] = true;
        make(move);
    }
}

/// Whether the target isn't below the node, where an earlier move may have brought it, and the tree
/// gets not too deep.
bool Optimizer::keeps_tree(const Move& move) const {
    std::uint32_t depth = 1;
    for (std::uint32_t i = move.target; i != 0; i = parent(i)) {
        if (i == move.node) return false;
        ++depth;
    }
    return depth + std::max(heights_[move.node], heights_[move.target]) <= most_depth_;
}

void Optimizer::make(const Move& move) {
    const Subtree node = at(move.node), other = at(sibling(move.node)), target = at(move.target);
    const std::uint32_t pair = pair_of(move.node), left = 2 * pair + 1;
    // The sibling takes the parent's place. Their pair is free for the node and its new sibling.
    put(parents_[pair], other);
    put(left, target);
    put(left + 1, node);
    // Its box is made by the next refit; heights only grow until then, which is enough for a bound.
    put(move.target, {{{}, left, 0}, 0, 0});
    std::uint32_t above = move.target, least = 1 + std::max(node.height, target.height);
    while (heights_[above] < least) {
        heights_[above] = least++;
        if (above == 0) break;
        above = parent(above);
    }
}

void Optimizer::put(std::uint32_t place, const Subtree& subtree) {
    nodes_[place] = subtree.root;
    heights_[place] = subtree.height;
    areas_[place] = subtree.area;
    if (!subtree.root.is_leaf()) parents_[pair_of(subtree.root.left())] = place;
}

}  // namespace

void optimize_by_reinsertion(Tree& tree, const ReinsertionOptions& options) {
    if (options.rounds < 0 || !(options.largest_part >= 0 && options.largest_part <= 1) ||
        !(options.least_gain >= 0))
        throw InvalidInput(
            "optimize_by_reinsertion: expected rounds and a least gain of at least 0 and a part of "
            "0 to 1");
    if (tree.nodes.size() < 5) return;
    Optimizer(tree, options).run();
    add_parents(tree);
}

}  // namespace boxwood
