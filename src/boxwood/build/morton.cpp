// SPDX-License-Identifier: Apache-2.0
// Top-down construction without looking at any box: sort the primitives along a curve that fills
// space cell by cell, each cell split in two halves. A node is then a range of the sorted codes,
// and its split the place where the highest bit in which they differ turns from 0 to 1. Primitives
// that share a cell get new codes within their own bounds, so that one far away doesn't push all
// others into one cell. O(n) for the codes and the sort, O(n log n) for the searches.
// Sources: Lauterbach et al., "Fast BVH Construction on GPUs", Computer Graphics Forum 28(2), 2009;
// Karras, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees", High
// Performance Graphics 2012. Explained in docs/algorithms/morton.md.
#include "boxwood/build/morton.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "boxwood/build/morton_order.h"
#include "boxwood/build/slots.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/vector_box.h"
#include "boxwood/tree/parents.h"

namespace boxwood {

namespace {

/// Below this depth cells aren't cut anew. What is in one of them is halved by index.
constexpr int kDeepestRefinement = 33;

constexpr std::uint32_t kPrefetch = 48;

struct Range {
    std::uint32_t begin, end;
    int depth;

    std::uint32_t size() const { return end - begin; }
};

/// A part of the tree that one task builds. Its nodes count from 0 until they are put in place.
struct Subtree {
    Range range;
    std::uint32_t root;  ///< in the tree
    std::vector<Node> nodes = {};
    int deepest = 0;  ///< of its leaves, counted from the tree's root
};

class MortonBuilder {
public:
    MortonBuilder(std::span<const Box3f> boxes, const MortonOptions& options)
        : boxes_(boxes),
          largest_leaf_(options.largest_leaf),
          full_leaves_(options.full_leaves),
          memory_(is_enough(options.scratch) ? 0 : 2 * boxes.size() * sizeof(MortonKey)) {
        std::byte* memory = is_enough(options.scratch) ? options.scratch.data() : memory_.data();
        keys_ = {reinterpret_cast<MortonKey*>(memory), boxes.size()};
        scratch_ = {keys_.data() + boxes.size(), boxes.size()};
    }

    Tree build() && {
        number_primitives(keys_);
        resize_on_huge_pages(tree_.order, boxes_.size());
        tree_.nodes.resize(1);
        split_into_subtrees(0, {0, static_cast<std::uint32_t>(boxes_.size()), 0});
        parallel_for(subtrees_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) build_subtree(subtrees_[i]);
        });
        put_in_place();
        const bool is_deep = std::any_of(subtrees_.begin(), subtrees_.end(), [](const Subtree& s) {
            return s.deepest > static_cast<int>(kDeepestWithoutParents);
        });
        if (is_deep) add_parents(tree_);
        return std::move(tree_);
    }

private:
    bool is_enough(std::span<std::byte> scratch) const {
        return scratch.size() >= 2 * boxes_.size() * sizeof(MortonKey) &&
               reinterpret_cast<std::uintptr_t>(scratch.data()) % alignof(MortonKey) == 0;
    }

    void split_into_subtrees(std::uint32_t index, const Range& range) {
        if (range.size() <= std::max(kSmallestTask, largest_leaf_)) {
            subtrees_.push_back({range, index});
            return;
        }
        const std::uint32_t middle = split(range);
        const std::uint32_t left = add_children(tree_.nodes, index);
        split_into_subtrees(left, {range.begin, middle, range.depth + 1});
        split_into_subtrees(left + 1, {middle, range.end, range.depth + 1});
    }

    void build_subtree(Subtree& subtree) {
        subtree.nodes.reserve(2 * subtree.range.size() / ((largest_leaf_ + 1) / 2));
        subtree.nodes.resize(1);
        build_node(subtree, 0, subtree.range);
    }

    void build_node(Subtree& subtree, std::uint32_t index, const Range& range) {
        std::vector<Node>& nodes = subtree.nodes;
        if (range.size() <= largest_leaf_) {
            make_leaf(nodes[index], range);
            subtree.deepest = std::max(subtree.deepest, range.depth);
            return;
        }
        const std::uint32_t middle = split(range);
        const std::uint32_t left = add_children(nodes, index);
        build_node(subtree, left, {range.begin, middle, range.depth + 1});
        build_node(subtree, left + 1, {middle, range.end, range.depth + 1});
        nodes[index].box = merged(nodes[left].box, nodes[left + 1].box);
    }

    static std::uint32_t add_children(std::vector<Node>& nodes, std::uint32_t index) {
        const auto left = static_cast<std::uint32_t>(nodes.size());
        nodes.resize(left + 2);
        nodes[index].first = left;
        return left;
    }

    void make_leaf(Node& node, const Range& range) {
        node.first = range.begin;
        node.count = range.size();
        VectorBox box;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            // Boxes lie anywhere in memory: ask early for those of leaves to come.
            const std::size_t ahead = std::min<std::size_t>(i + kPrefetch, keys_.size() - 1);
            __builtin_prefetch(&boxes_[primitive_of(keys_[ahead])]);
            tree_.order[i] = primitive_of(keys_[i]);
            box.extend(VectorBox(boxes_[tree_.order[i]]));
        }
        node.box = box.box();
    }

    /// The first key of the right side.
    std::uint32_t split(const Range& range) {
        const auto keys = keys_.subspan(range.begin, range.size());
        const auto is_one_cell = [&] { return code_of(keys.front()) == code_of(keys.back()); };
        if (is_one_cell() && range.depth <= kDeepestRefinement)
            sort_by_morton_code(boxes_, keys, scratch_.subspan(range.begin, range.size()));
        if (is_one_cell()) return range.begin + (range.size() + 1) / 2;

        const std::uint32_t last = code_of(keys.back());
        const int bit = std::bit_width(code_of(keys.front()) ^ last) - 1;
        const MortonKey first_of_right = morton_key(last >> bit << bit, 0);
        const auto middle = std::lower_bound(keys.begin(), keys.end(), first_of_right);
        const auto left = static_cast<std::uint32_t>(middle - keys.begin());
        return range.begin + (full_leaves_ ? with_full_leaves(left, range.size()) : left);
    }

    /// The size of the left side nearest to what it is to be that leaves all leaves full but one,
    /// in ranges of few of them: either side is a whole number of leaves.
    std::uint32_t with_full_leaves(std::uint32_t left, std::uint32_t size) const {
        constexpr std::uint32_t kFewLeaves = 3;
        if (size > kFewLeaves * largest_leaf_) return left;
        const std::uint32_t most = (size - 1) / largest_leaf_;
        const auto whole = [&](std::uint32_t count) {
            const std::uint32_t leaves = (count + largest_leaf_ / 2) / largest_leaf_;
            return std::clamp(leaves, 1u, most) * largest_leaf_;
        };
        const auto distance = [&](std::uint32_t other) {
            return other > left ? other - left : left - other;
        };
        const std::uint32_t full_left = whole(left), full_right = size - whole(size - left);
        return distance(full_left) <= distance(full_right) ? full_left : full_right;
    }

    /// Behind the nodes above the subtrees, one subtree after another; roots are there already.
    void put_in_place() {
        const auto top = static_cast<std::uint32_t>(tree_.nodes.size());
        std::vector<std::uint32_t> place(subtrees_.size() + 1, top);
        for (std::size_t i = 0; i < subtrees_.size(); ++i)
            place[i + 1] = place[i] + static_cast<std::uint32_t>(subtrees_[i].nodes.size()) - 1;
        std::vector<Node> upper = std::exchange(tree_.nodes, {});
        resize_on_huge_pages(tree_.nodes, place.back());
        std::copy(upper.begin(), upper.end(), tree_.nodes.begin());
        parallel_for(subtrees_.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::vector<Node>& nodes = subtrees_[i].nodes;
                const auto moved = [&](Node node) {
                    if (!node.is_leaf()) node.first += place[i] - 1;
                    return node;
                };
                tree_.nodes[subtrees_[i].root] = moved(nodes[0]);
                std::transform(nodes.begin() + 1, nodes.end(), tree_.nodes.begin() + place[i],
                               moved);
            }
        });
        // Children come after their parents, so that backwards each box is known before it's
        // needed.
        for (std::uint32_t i = top; i-- > 0;) {
            Node& node = tree_.nodes[i];
            if (!node.is_leaf() && node.first < top)
                node.box = merged(tree_.nodes[node.left()].box, tree_.nodes[node.right()].box);
        }
    }

    std::span<const Box3f> boxes_;
    std::uint32_t largest_leaf_;
    bool full_leaves_;
    Arena memory_;
    std::span<MortonKey> keys_, scratch_;
    std::vector<Subtree> subtrees_;
    Tree tree_;
};

}  // namespace

Tree build_morton(std::span<const Box3f> boxes, const MortonOptions& options) {
    if (options.largest_leaf < 1) throw InvalidInput("build_morton: expected leaves of at least 1");
    if (boxes.empty()) return {};
    return MortonBuilder(boxes, options).build();
}

}  // namespace boxwood
