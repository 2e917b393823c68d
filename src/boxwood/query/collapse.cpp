// SPDX-License-Identifier: Apache-2.0
// From a binary tree to one with up to N children a node and up to N triangles a leaf: a plan says
// which nodes stay. Then sizes are summed up, so that subtrees are written side by side to places
// known in advance: depth first. See docs/algorithms/wide_tree.md.
#include "boxwood/query/collapse.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <type_traits>
#include <utility>

#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_node.h"
#include "boxwood/query/wide_plan.h"
#include "boxwood/query/write_block.h"
#include "boxwood/query/write_node.h"
#include "boxwood/tree/bound_depth.h"

namespace boxwood {

namespace {

/// Subtrees of fewer triangles are done by the task that comes to them.
constexpr std::uint32_t kSmallestTask = 4096;

template <int N>
class Collapser {
public:
    /// Precondition: the plan is made.
    Collapser(MeshView mesh, const Tree& tree, WidePlan<N>& plan, const CollapseOptions& options)
        : mesh_(mesh),
          tree_(tree),
          plan_(plan),
          scale_(options.scale),
          compact_(options.compact),
          extents_memory_(tree.nodes.size() * sizeof(Extent)),
          extents_(reinterpret_cast<Extent*>(extents_memory_.data())) {}

    Collapsed run(Arena spare) {
        Collapsed result;
        result.cost = plan_.cost();
        result.memory = taken(std::move(spare), measure(0));
        result.stack_size = extents_[0].stack_size;
        memory_ = result.memory.data();
        emit(0, 0);
        std::sort(left_out_.begin(), left_out_.end());
        left_out_.erase(std::unique(left_out_.begin(), left_out_.end()), left_out_.end());
        result.left_out = std::move(left_out_);
        return result;
    }

private:
    /// What a wide subtree, or a compact leaf, takes.
    struct Extent {
        std::uint32_t units;  ///< of memory
        int stack_size;       ///< 0 for a leaf
    };

    static constexpr std::uint32_t units(std::size_t bytes) {
        return static_cast<std::uint32_t>(bytes / kReferenceUnit);
    }

    static Arena taken(Arena spare, std::size_t bytes) {
        if (spare.size() < bytes) {
            spare = {};
            return Arena(bytes);
        }
        spare.shrink(bytes);
        return spare;
    }

    template <class Visit>
    void for_each_child(std::uint32_t index, const Visit& visit) {
        const std::size_t count = plan_.children(index).size();
        parallel_for(count, plan_.triangles(index) > kSmallestTask ? 1 : N,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i) visit(i);
                     });
    }

    /// The bytes of the wide subtree.
    std::size_t measure(std::uint32_t index) {
        plan_.choose_children(index, [&](std::uint32_t child) { leave_out_below(child); });
        const auto children = plan_.children(index);
        for_each_child(index, [&](std::size_t i) {
            if (!plan_.is_leaf(children[i])) {
                measure(children[i]);
            } else {
                extents_[children[i]] = {units(leaf_bytes(children[i])), 0};
            }
        });
        std::size_t bytes = sizeof(WideNode<N>);
        int deepest = 0;
        for (const std::uint32_t child : children) {
            bytes += extents_[child].units * kReferenceUnit;
            deepest = std::max(deepest, extents_[child].stack_size);
        }
        if (bytes / kReferenceUnit >= kLeafBit)
            throw InvalidInput("WideTree: more triangles than a wide tree can hold");
        // A walk goes on with one child and remembers the others.
        const int others = std::max(static_cast<int>(children.size()), 1) - 1;
        extents_[index] = {units(bytes), deepest + others};
        return bytes;
    }

    std::size_t leaf_bytes(std::uint32_t index) const {
        if (!compact_) return sizeof(TriangleBlock<N>);
        BlockTriangles<N> triangles;
        gather(index, triangles);
        triangles.sort();
        return compact_block_bytes(BlockVertices<N>(mesh_, triangles));
    }

    void emit(std::uint32_t index, std::uint32_t place) {
        auto* node = new (memory_ + byte_offset(place)) WideNode<N>;
        // Leaves follow their node, then come the subtrees.
        std::uint32_t next = place + units(sizeof(WideNode<N>));
        const auto children = plan_.children(index);
        for (const bool leaves : {true, false}) {
            for (std::size_t i = 0; i < children.size(); ++i) {
                if (plan_.is_leaf(children[i]) != leaves) continue;
                node->child[i] = next | (leaves ? kLeafBit : 0);
                next += extents_[children[i]].units;
            }
        }
        emit_boxes(index, *node);
        emit_blocks(index, *node);
        for_each_child(index, [&](std::size_t i) {
            if (!plan_.is_leaf(children[i])) emit(children[i], node->child[i]);
        });
    }

    void emit_blocks(std::uint32_t index, const WideNode<N>& node) {
        std::array<BlockTriangles<N>, N> blocks;
        std::array<WideReference, N> places;
        int count = 0;
        const auto children = plan_.children(index);
        for (std::size_t i = 0; i < children.size(); ++i) {
            if (!is_leaf(node.child[i])) continue;
            gather(children[i], blocks[count]);
            blocks[count].fetch_faces(mesh_);
            places[count++] = node.child[i];
        }
        for (int i = 0; i < count; ++i) {
            if (i + 1 < count) blocks[i + 1].fetch_vertices(mesh_);
            blocks[i].sort();
            if (emit_block(blocks[i], places[i])) continue;
            leave_out(blocks[i]);
            emit_block(blocks[i], places[i]);
        }
    }

    /// False when it has triangles that nothing hits.
    bool emit_block(const BlockTriangles<N>& triangles, WideReference reference) const {
        std::byte* place = memory_ + byte_offset(reference);
        if (!compact_) return write_block(mesh_, scale_, triangles, *new (place) TriangleBlock<N>);
        const BlockVertices<N> vertices(mesh_, triangles);
        return write_compact_block(mesh_, scale_, triangles, vertices,
                                   *new (place) CompactBlock<N>);
    }

    void emit_boxes(std::uint32_t index, WideNode<N>& node) const {
        std::array<Box3f, N> boxes;
        const auto children = plan_.children(index);
        for (std::size_t i = 0; i < N; ++i) {
            if (i < children.size()) {
                boxes[i] = tree_.nodes[children[i]].box;
            } else {
                node.child[i] = 0;
            }
        }
        write_boxes<N>(boxes, scale_, node);
    }

    void leave_out(BlockTriangles<N>& triangles) {
        const std::lock_guard lock(left_out_mutex_);
        int kept = 0;
        for (int i = 0; i < triangles.count; ++i) {
            if (is_in_float_range(mesh_, triangles.index[i])) {
                triangles.index[kept++] = triangles.index[i];
            } else {
                left_out_.push_back(triangles.index[i]);
            }
        }
        triangles.count = kept;
    }

    void leave_out_below(std::uint32_t index) {
        const Node& node = tree_.nodes[index];
        if (node.is_leaf()) {
            const std::lock_guard lock(left_out_mutex_);
            const auto triangles = tree_.primitives(node);
            left_out_.insert(left_out_.end(), triangles.begin(), triangles.end());
        } else {
            leave_out_below(node.left());
            leave_out_below(node.right());
        }
    }

    /// The triangles below, as they come.
    void gather(std::uint32_t index, BlockTriangles<N>& triangles) const {
        const Node& node = tree_.nodes[index];
        if (node.is_leaf()) {
            for (const std::uint32_t triangle : tree_.primitives(node))
                triangles.index[triangles.count++] = triangle;
        } else {
            gather(node.left(), triangles);
            gather(node.right(), triangles);
        }
    }

    MeshView mesh_;
    const Tree& tree_;
    WidePlan<N>& plan_;
    float scale_;
    bool compact_;
    Arena extents_memory_;
    Extent* extents_;
    std::byte* memory_ = nullptr;
    std::mutex left_out_mutex_;
    std::vector<std::uint32_t> left_out_;
};

/// Calls use(tree, plan) with the tree's plan, and a flatter tree where it is too deep for one.
template <int N, class Use>
auto with_plan(const Tree& tree, const Use& use) {
    if (WidePlan<N> plan(tree); plan.make()) return use(tree, plan);
    const Tree flatter = bound_depth(tree, WidePlan<N>::kDeepest - 32);
    WidePlan<N> plan(flatter);
    plan.make();
    return use(flatter, plan);
}

/// Calls function with the width as a type.
template <class Function>
auto with_width(int width, const Function& function) {
    switch (width) {
        case 16:
            return function(std::integral_constant<int, 16>());
        case 8:
            return function(std::integral_constant<int, 8>());
        default:
            return function(std::integral_constant<int, 4>());
    }
}

}  // namespace

Collapsed collapse(MeshView mesh, const Tree& tree, CollapseOptions options) {
    if (tree.is_empty()) return {};
    return with_width(options.width, [&](auto n) {
        return with_plan<n>(tree, [&](const Tree& planned, WidePlan<n>& plan) {
            return Collapser<n>(mesh, planned, plan, options).run(std::move(options.spare));
        });
    });
}

double collapsed_cost(const Tree& tree, int width) {
    if (tree.is_empty()) return 0;
    return with_width(width, [&](auto n) {
        return with_plan<n>(tree, [](const Tree&, const WidePlan<n>& plan) { return plan.cost(); });
    });
}

}  // namespace boxwood
