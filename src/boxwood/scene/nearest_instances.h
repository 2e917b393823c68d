// SPDX-License-Identifier: Apache-2.0
// Walking the tree over the instances of a scene around a point, and through a box.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "boxwood/core/box.h"
#include "boxwood/query/stack.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// A bound from below on the distance of the point to what is in the box, rounding included.
inline double least_distance(const Vec3d& point, const Box3f& box) {
    const Vec3d below = box.lo.cast<double>() - point, above = point - box.hi.cast<double>();
    const double distance = below.cwiseMax(above).cwiseMax(0).norm();
    const double reach = largest_coordinate(box) + point.lpNorm<Eigen::Infinity>();
    return distance - 0x1p-46 * reach;
}

/// Calls visit(instance) for each that may have something within the distance that it returned
/// last, at first `farthest`; nearer ones mostly first. Precondition: the tree is no deeper than
/// kDeepestWithoutParents.
template <class Visit>
void walk_nearest(const Tree& tree, const Vec3d& point, double farthest, const Visit& visit) {
    if (tree.is_empty()) return;
    struct Entry {
        std::uint32_t node;
        double distance;
    };
    Stack<Entry, kDeepestWithoutParents + 1> waiting;
    const auto entry_of = [&](std::uint32_t node) {
        const Box3f& box = tree.nodes[node].box;
        constexpr double kNever = std::numeric_limits<double>::infinity();
        return Entry{node, box.is_empty() ? kNever : least_distance(point, box)};
    };
    waiting.push(entry_of(0));
    while (!waiting.is_empty()) {
        const Entry entry = waiting.pop();
        if (!(entry.distance <= farthest)) continue;
        const Node& node = tree.nodes[entry.node];
        if (node.is_leaf()) {
            for (const std::uint32_t instance : tree.primitives(node)) farthest = visit(instance);
            continue;
        }
        Entry near = entry_of(node.left()), far = entry_of(node.right());
        if (far.distance < near.distance) std::swap(near, far);
        waiting.push(far);
        waiting.push(near);
    }
}

/// Calls visit(instance) for each whose box touches the box, until it returns true. The same
/// precondition.
template <class Visit>
void walk_touching(const Tree& tree, const Box3d& box, const Visit& visit) {
    if (tree.is_empty()) return;
    Stack<std::uint32_t, kDeepestWithoutParents + 1> waiting;
    waiting.push(0);
    while (!waiting.is_empty()) {
        const Node& node = tree.nodes[waiting.pop()];
        const bool touches = (node.box.lo.cast<double>().array() <= box.hi.array()).all() &&
                             (box.lo.array() <= node.box.hi.cast<double>().array()).all();
        if (!touches) continue;
        if (!node.is_leaf()) {
            waiting.push(node.right());
            waiting.push(node.left());
            continue;
        }
        for (const std::uint32_t instance : tree.primitives(node))
            if (visit(instance)) return;
    }
}

}  // namespace boxwood
