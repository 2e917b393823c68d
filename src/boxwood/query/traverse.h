// SPDX-License-Identifier: Apache-2.0
// Walking a binary tree of boxes along a ray, iteratively and front to back: at an inner node go on
// with the child that the ray enters first and keep the other for later; skip what the ray enters
// only behind the closest hit so far. Explained in docs/algorithms/closest_hit.md.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "boxwood/core/ray.h"
#include "boxwood/core/ray_box.h"
#include "boxwood/query/stack.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// What a query did, for heat maps and measurements.
struct TraversalCounts {
    std::uint64_t nodes = 0;       ///< visited
    std::uint64_t primitives = 0;  ///< tested

    std::uint64_t steps() const { return nodes + primitives; }
};

/// What a visit returns when the walk can stop.
constexpr double kEndOfWalk = -std::numeric_limits<double>::infinity();

/// A node on the way of a ray.
struct WalkEntry {
    std::uint32_t node;
    double t;  ///< where the ray enters it; SlabRay::kMiss if it doesn't
};

/// The node to visit next when all below `done` has been: one below `top`, found by way of
/// Tree::parents, or one with kMiss when there is none left. For trees too deep for the stack.
WalkEntry find_back(const Tree& tree, SlabRay slabs, double t_min, double t_max, std::uint32_t done,
                    std::uint32_t top) noexcept;

/// Calls visit(primitive, t_max) for each primitive whose leaf the ray enters before t_max, nearest
/// leaves first. It returns the new t_max: the distance of the hit if there is one, else the old;
/// or kEndOfWalk. Takes no memory from the heap and little of the call stack, however deep the tree
/// is. The ray may be off by so much from the one that visit asks about.
/// Preconditions: is_traceable(ray), a valid tree that isn't empty.
template <class Visit>
void traverse(const Tree& tree, const Ray& ray, Visit&& visit, TraversalCounts* counts = nullptr,
              double off = 0) noexcept {
    if (tree.root().box.is_empty()) return;
    const SlabRay slabs(ray, tree.root().box, off);
    double t_max = ray.t_max;
    WalkEntry current = {0, slabs.intersect(tree.root().box, ray.t_min, t_max)};
    if (current.t == SlabRay::kMiss) return;

    // Once the stack is full, what is below this node is walked without it.
    Stack<WalkEntry, kDeepestWithoutParents> waiting;
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t unstacked = kNone;
    for (;;) {
        // On a tie the box may hold a hit at the same distance on a triangle of lower index.
        if (current.t <= t_max) {
            const Node& node = tree.nodes[current.node];
            if (counts) ++counts->nodes;
            if (!node.is_leaf()) {
                WalkEntry near = {node.left(), 0}, far = {node.right(), 0};
                near.t = slabs.intersect(tree.nodes[near.node].box, ray.t_min, t_max);
                far.t = slabs.intersect(tree.nodes[far.node].box, ray.t_min, t_max);
                if (far.t < near.t) std::swap(near, far);
                if (far.t != SlabRay::kMiss) {
                    if (!waiting.is_full()) {
                        waiting.push(far);
                    } else if (unstacked == kNone) {
                        unstacked = current.node;
                    }
                }
                if (near.t != SlabRay::kMiss) {
                    current = near;
                    continue;
                }
            } else {
                for (const std::uint32_t primitive : tree.primitives(node)) {
                    if (counts) ++counts->primitives;
                    t_max = visit(primitive, t_max);
                }
                if (t_max == kEndOfWalk) return;
            }
        }
        if (unstacked != kNone) {
            current = find_back(tree, slabs, ray.t_min, t_max, current.node, unstacked);
            if (current.t != SlabRay::kMiss) continue;
            unstacked = kNone;
        }
        if (waiting.is_empty()) return;
        current = waiting.pop();
    }
}

}  // namespace boxwood
