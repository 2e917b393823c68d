// SPDX-License-Identifier: Apache-2.0
// From a binary tree to one with up to N children a node and up to N triangles a leaf. A wide node
// stands for the top of a binary subtree; which top is best, and where leaves begin, is found by
// dynamic programming: with at most i places in its parent a subtree costs
//   cost(i) = min(cost(i - 1), min over k of left.cost(k) + right.cost(i - k)),
//   cost(1) = min(as a leaf, as a node: its own visit + min over k of left(k) + right(N - k)),
// where a visit is weighed by the chance that a ray makes it, the surface area. Then sizes are
// summed up, so that subtrees are written side by side to places known in advance: depth first.
// Sources: Wald et al., "Getting Rid of Packets", 2008; Ylitie et al., "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", HPG 2017. See docs/algorithms/wide_tree.md.
#include "boxwood/query/collapse.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <type_traits>

#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_cost.h"
#include "boxwood/query/wide_node.h"
#include "boxwood/query/write_block.h"
#include "boxwood/query/write_node.h"
#include "boxwood/tree/bound_depth.h"

namespace boxwood {

namespace {

/// Where one block will do, several have to bring the cost down to this share: memory costs as
/// well.
constexpr float kWorthMoreBlocks = 0.75f;

/// Trees that are deeper are made flatter first, which bounds the stack of a walk:
/// (kDeepest + 32) * 15 places are less than kStackSize.
constexpr int kDeepest = 120;

/// Subtrees of fewer triangles are done by the task that comes to them.
constexpr std::uint32_t kSmallestTask = 4096;
/// What is left below this depth is planned by the task that comes to it.
constexpr int kTaskDepth = 8;

template <int N>
class Collapser {
public:
    Collapser(MeshView mesh, const Tree& tree, float scale = 1, bool compact = false)
        : mesh_(mesh),
          tree_(tree),
          scale_(scale),
          compact_(compact),
          rows_memory_(tree.nodes.size() * sizeof(Row)),
          plans_memory_(tree.nodes.size() * sizeof(Plan)),
          rows_(reinterpret_cast<Row*>(rows_memory_.data())),
          plans_(reinterpret_cast<Plan*>(plans_memory_.data())) {
        const double area = tree.root().box.surface_area();
        inverse_area_ = area > 0 ? 1 / area : 0;
    }

    /// Nothing when the tree is too deep; then the spare memory is still there.
    std::optional<Collapsed> run(Arena& spare) {
        if (!plan(0, 0)) return std::nullopt;
        Collapsed result;
        result.cost = root_cost();
        result.memory = taken(spare, measure(0));
        result.stack_size = plans_[0].stack_size;
        memory_ = result.memory.data();
        emit(0, 0);
        std::sort(left_out_.begin(), left_out_.end());
        left_out_.erase(std::unique(left_out_.begin(), left_out_.end()), left_out_.end());
        result.left_out = std::move(left_out_);
        return result;
    }

    /// Likewise.
    std::optional<double> cost() { return plan(0, 0) ? std::optional(root_cost()) : std::nullopt; }

private:
    /// What is known of a binary node: first the costs of its subtree, later, where a wide node
    /// stands for it, the children of that.
    union Row {
        float costs[N];  ///< with up to i + 1 places
        std::uint32_t children[N];
    };

    struct Plan {
        std::uint32_t count;    ///< triangles
        std::uint32_t units;    ///< of memory, where it becomes a node or a compact leaf
        int stack_size;         ///< where it becomes a node
        std::uint8_t children;  ///< likewise
        std::uint8_t places;    ///< that it can use at most
        bool is_leaf;
    };

    struct Children {
        std::array<std::uint32_t, N> node;
        int count = 0;

        void add(std::uint32_t child) { node[count++] = child; }
    };

    static constexpr std::uint32_t units(std::size_t bytes) {
        return static_cast<std::uint32_t>(bytes / kReferenceUnit);
    }

    float relative_area(const Node& node) const {
        return static_cast<float>(node.box.surface_area() * inverse_area_);
    }

    float cost(std::uint32_t index, int places) const { return rows_[index].costs[places - 1]; }

    static Arena taken(Arena& spare, std::size_t bytes) {
        Arena memory = std::move(spare);
        if (memory.size() < bytes) {
            memory = {};
            return Arena(bytes);
        }
        memory.shrink(bytes);
        return memory;
    }

    /// The root is a node, whatever is cheaper.
    double root_cost() const {
        return cost(0, 1) + (plans_[0].is_leaf && inverse_area_ > 0 ? kNodeCost : 0);
    }

    /// Fills plans and rows from the leaves up; false where it is too deep.
    bool plan(std::uint32_t index, int depth) {
        const Node& node = tree_.nodes[index];
        if (node.is_leaf()) {
            if (node.count > N)
                throw InvalidInput("WideTree: a leaf of the tree has more triangles than a block");
            plans_[index] = {node.count, 0, 0, 0, 1, true};
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
        const Plan& left = plans_[node.left()];
        const Plan& right = plans_[node.right()];
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
        const std::uint32_t count = left.count + right.count;
        const float as_node = area * kNodeCost + shared[places];
        const float as_leaf =
            count <= N ? area * kBlockCost : std::numeric_limits<float>::infinity();
        const bool is_leaf = as_leaf <= as_node;
        if (is_leaf && shared[places] > kWorthMoreBlocks * as_leaf) places = 1;
        plans_[index] = {count, 0, 0, 0, static_cast<std::uint8_t>(places), is_leaf};
        float best = std::min(as_leaf, as_node);
        rows_[index].costs[0] = best;
        for (int i = 2; i <= places; ++i)
            rows_[index].costs[i - 1] = best = std::min(best, shared[i]);
    }

    /// The children of the wide node that stands for this one, by their area. The root is a node
    /// even when all of the tree fits into a block, which then is its child.
    Children children_of(std::uint32_t index) {
        Children opened;
        if (plans_[index].is_leaf) {
            opened.add(index);
        } else {
            share(index, plans_[index].places, opened);
        }
        Children children;
        std::array<float, N> areas;
        for (int i = 0; i < opened.count; ++i) {
            const std::uint32_t child = opened.node[i];
            // What nothing hits needs no place.
            if (tree_.nodes[child].box.is_empty()) {
                leave_out_below(child);
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
        return children;
    }

    /// Shares places among what is below the node.
    void share(std::uint32_t index, int places, Children& children) const {
        const std::uint32_t left = tree_.nodes[index].left();
        const std::uint32_t right = tree_.nodes[index].right();
        const int first = std::max(1, places - plans_[right].places);
        const int last = std::min<int>(plans_[left].places, places - 1);
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

    std::span<const std::uint32_t> children(std::uint32_t index) const {
        return {rows_[index].children, plans_[index].children};
    }

    template <class Visit>
    void for_each_child(std::uint32_t index, const Visit& visit) {
        const std::size_t count = plans_[index].children;
        parallel_for(count, plans_[index].count > kSmallestTask ? 1 : N,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i) visit(i);
                     });
    }

    /// The bytes of the wide subtree. Nobody asks for the costs of its root any more.
    std::size_t measure(std::uint32_t index) {
        const Children found = children_of(index);
        std::copy_n(found.node.begin(), found.count, rows_[index].children);
        plans_[index].children = static_cast<std::uint8_t>(found.count);
        for_each_child(index, [&](std::size_t i) {
            const std::uint32_t child = found.node[i];
            if (!plans_[child].is_leaf) {
                measure(child);
            } else if (compact_) {
                BlockTriangles<N> triangles;
                gather(child, triangles);
                triangles.sort();
                plans_[child].units =
                    units(compact_block_bytes(BlockVertices<N>(mesh_, triangles)));
            }
        });
        std::size_t bytes = sizeof(WideNode<N>);
        int deepest = 0;
        for (const std::uint32_t child : children(index)) {
            bytes += bytes_of(child);
            deepest = std::max(deepest, plans_[child].stack_size);
        }
        if (bytes / kReferenceUnit >= kLeafBit)
            throw InvalidInput("WideTree: more triangles than a wide tree can hold");
        plans_[index].units = units(bytes);
        // A walk goes on with one child and remembers the others.
        plans_[index].stack_size = deepest + std::max(found.count, 1) - 1;
        return bytes;
    }

    std::size_t bytes_of(std::uint32_t child) const {
        return plans_[child].is_leaf && !compact_ ? sizeof(TriangleBlock<N>)
                                                  : plans_[child].units * kReferenceUnit;
    }

    void emit(std::uint32_t index, std::uint32_t place) {
        auto* node = new (memory_ + byte_offset(place)) WideNode<N>;
        // Leaves follow their node, then come the subtrees.
        std::uint32_t next = place + units(sizeof(WideNode<N>));
        for (const bool leaves : {true, false}) {
            for (std::size_t i = 0; i < children(index).size(); ++i) {
                const std::uint32_t child = children(index)[i];
                if (plans_[child].is_leaf != leaves) continue;
                node->child[i] = next | (leaves ? kLeafBit : 0);
                next += units(bytes_of(child));
            }
        }
        emit_boxes(index, *node);
        emit_blocks(index, *node);
        for_each_child(index, [&](std::size_t i) {
            const std::uint32_t child = children(index)[i];
            if (!plans_[child].is_leaf) emit(child, node->child[i]);
        });
    }

    void emit_blocks(std::uint32_t index, const WideNode<N>& node) {
        std::array<BlockTriangles<N>, N> blocks;
        std::array<WideReference, N> places;
        int count = 0;
        for (std::size_t i = 0; i < children(index).size(); ++i) {
            if (!is_leaf(node.child[i])) continue;
            gather(children(index)[i], blocks[count]);
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
        for (int i = 0; i < N; ++i) {
            if (i < plans_[index].children) {
                boxes[i] = tree_.nodes[children(index)[i]].box;
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
    float scale_;
    bool compact_;
    Arena rows_memory_, plans_memory_;
    Row* rows_;
    Plan* plans_;
    double inverse_area_;
    std::byte* memory_ = nullptr;
    std::mutex left_out_mutex_;
    std::vector<std::uint32_t> left_out_;
};

template <int N>
Collapsed collapse_to(MeshView mesh, const Tree& tree, CollapseOptions& options) {
    if (auto result = Collapser<N>(mesh, tree, options.scale, options.compact).run(options.spare))
        return std::move(*result);
    const Tree flatter = bound_depth(tree, kDeepest - 32);
    return std::move(
        *Collapser<N>(mesh, flatter, options.scale, options.compact).run(options.spare));
}

template <int N>
double cost_of(const Tree& tree) {
    if (const auto cost = Collapser<N>({}, tree).cost()) return *cost;
    return *Collapser<N>({}, bound_depth(tree, kDeepest - 32)).cost();
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
    return with_width(options.width, [&](auto n) { return collapse_to<n>(mesh, tree, options); });
}

double collapsed_cost(const Tree& tree, int width) {
    if (tree.is_empty()) return 0;
    return with_width(width, [&](auto n) { return cost_of<n>(tree); });
}

}  // namespace boxwood
