// SPDX-License-Identifier: Apache-2.0
// Top-down construction by the surface area heuristic, without the bins of binned_sah.cpp: every
// split between two centroids along an axis is tried. The primitives are sorted once along each
// axis. A sweep from the right and one from the left then find a node's cheapest split, and its
// children get the three orders by a stable partition: O(n) a level, O(n log n) in all.
// Sources: Wald, Boulos and Shirley, "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume
// Hierarchies", ACM TOG 26(1), 2007; for sorting once, Wald and Havran, "On building fast kd-Trees
// for Ray Tracing, and on doing that in O(N log N)", IEEE Symposium on Interactive Ray Tracing,
// 2006. Explained in docs/algorithms/sweep_sah.md.
#include "boxwood/build/sweep_sah.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "boxwood/build/slots.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/error.h"
#include "boxwood/core/float_bits.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/radix_sort.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 8192;
/// Below this depth ranges are halved, so that no input makes a deep tree.
constexpr int kDeepestSahSplit = 40;

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;             ///< -1: there is none
    std::uint32_t middle = 0;  ///< the first place of the right side
    std::uint32_t uneven = 0;  ///< how many more primitives one side has

    /// Of equal costs the evenest counts, so that equal boxes make a tree that isn't deep.
    bool is_better_than(const Split& other) const {
        return cost < other.cost || (cost == other.cost && uneven < other.uneven);
    }
};

/// Bits in the order of the floats. Those that aren't a number come last.
std::uint32_t ordered_bits(float x) {
    if (std::isnan(x)) return ~0u;
    const std::uint32_t bits = bits_of(x == 0 ? 0.0f : x);
    return bits >> 31 ? ~bits : bits | 1u << 31;
}

class SweepSahBuilder {
public:
    SweepSahBuilder(std::span<const Box3f> boxes, const SweepSahOptions& options)
        : boxes_(boxes),
          options_(options),
          scale_(unit_scale(boxes)),
          scratch_(boxes.size()),
          right_cost_(boxes.size()),
          is_left_(boxes.size()) {
        tree_.nodes.resize(2 * boxes.size() - 1);
        for (auto& order : orders_) order.resize(boxes.size());
    }

    Tree build() && {
        for (int axis = 0; axis < 3; ++axis) sort(axis);
        build_node(0, 0, static_cast<std::uint32_t>(boxes_.size()), 0);
        tree_.order = std::move(orders_[0]);
        close_gaps(tree_.nodes);
        return std::move(tree_);
    }

private:
    void sort(int axis) {
        std::vector<std::uint64_t> keys(boxes_.size()), sorted(boxes_.size());
        parallel_for(keys.size(), kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                keys[i] = std::uint64_t{ordered_bits(boxes_[i].centroid()[axis])} << 32 | i;
        });
        radix_sort(keys, sorted, 32, 32);
        parallel_for(keys.size(), kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                orders_[axis][i] = static_cast<std::uint32_t>(sorted[i]);
        });
    }

    void build_node(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        Node& node = tree_.nodes[index];
        for (std::uint32_t i = begin; i < end; ++i) node.box.extend(boxes_[orders_[0][i]]);
        const std::uint32_t count = end - begin;
        if (count == 1) return make_leaf(node, begin, end);

        Split split = depth < kDeepestSahSplit ? best_split(begin, end) : Split{};
        const double area = half_area(node.box);
        if (count <= options_.largest_leaf &&
            options_.primitive_cost * blocks(count) * area <=
                options_.node_cost * area + options_.primitive_cost * split.cost)
            return make_leaf(node, begin, end);
        if (split.axis < 0)
            split = {.axis = node.box.longest_axis(), .middle = begin + (count + 1) / 2};

        partition(split, begin, end);
        node.first = slot_of_children(split.middle);
        invoke_both(
            count > kSmallestTask, [&] { build_node(node.left(), begin, split.middle, depth + 1); },
            [&] { build_node(node.right(), split.middle, end, depth + 1); });
    }

    static void make_leaf(Node& node, std::uint32_t begin, std::uint32_t end) {
        node.first = begin;
        node.count = end - begin;
    }

    Split best_split(std::uint32_t begin, std::uint32_t end) {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = sweep(axis, begin, end);
            if (split.is_better_than(best)) best = split;
        }
        return best;
    }

    Split sweep(int axis, std::uint32_t begin, std::uint32_t end) {
        const std::vector<std::uint32_t>& order = orders_[axis];
        Box3f right;
        for (std::uint32_t i = end - 1; i > begin; --i) {
            right.extend(boxes_[order[i]]);
            right_cost_[i] = half_area(right) * blocks(end - i);
        }
        Split best = {.axis = axis};
        Box3f left;
        for (std::uint32_t i = begin + 1; i < end; ++i) {
            left.extend(boxes_[order[i - 1]]);
            const std::uint32_t on_left = i - begin, on_right = end - i;
            const Split split = {half_area(left) * blocks(on_left) + right_cost_[i], axis, i,
                                 std::max(on_left, on_right) - std::min(on_left, on_right)};
            if (split.is_better_than(best)) best = split;
        }
        return best;
    }

    /// Brings the left side's primitives to the front in all orders, each side in its order.
    void partition(const Split& split, std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i)
            is_left_[orders_[split.axis][i]] = i < split.middle;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == split.axis) continue;
            std::vector<std::uint32_t>& order = orders_[axis];
            std::uint32_t left = begin, right = split.middle;
            for (std::uint32_t i = begin; i < end; ++i)
                scratch_[is_left_[order[i]] ? left++ : right++] = order[i];
            std::copy(scratch_.begin() + begin, scratch_.begin() + end, order.begin() + begin);
        }
    }

    std::uint32_t blocks(std::uint32_t count) const {
        return (count + options_.leaf_block - 1) / options_.leaf_block;
    }
    /// In float, so that times a count it is exact in double, and equal costs are equal.
    double half_area(const Box3f& box) const {
        if (box.is_empty()) return 0;
        const Vec3f e = scale_ * box.hi - scale_ * box.lo;
        return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
    }

    std::span<const Box3f> boxes_;
    SweepSahOptions options_;
    float scale_;
    std::array<std::vector<std::uint32_t>, 3> orders_;  ///< along each axis, node by node
    std::vector<std::uint32_t> scratch_;
    std::vector<double> right_cost_;
    std::vector<std::uint8_t> is_left_;  ///< of each primitive
    Tree tree_;
};

}  // namespace

Tree build_sweep_sah(std::span<const Box3f> boxes, const SweepSahOptions& options) {
    if (options.largest_leaf < 1 || options.leaf_block < 1)
        throw InvalidInput("build_sweep_sah: expected leaves and blocks of at least 1");
    if (boxes.empty()) return {};
    return SweepSahBuilder(boxes, options).build();
}

}  // namespace boxwood
