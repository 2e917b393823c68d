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
#include <cfloat>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/wide_node.h"
#include "boxwood/tree/bound_depth.h"

namespace boxwood {

namespace {

/// Costs of a visit to a node and to a leaf, as measured.
constexpr float kNodeCost = 1;
constexpr float kBlockCost = 0.8f;

/// Trees that are deeper are made flatter first, which bounds the stack of a walk:
/// (kDeepest + 32) * 15 places are less than kStackSize.
constexpr int kDeepest = 120;

/// Subtrees of fewer triangles are done by the task that comes to them.
constexpr std::uint32_t kSmallestTask = 4096;

template <int N>
class Collapser {
public:
    Collapser(MeshView mesh, const Tree& tree, float scale)
        : mesh_(mesh),
          tree_(tree),
          scale_(scale),
          plans_(new Plan[tree.nodes.size()]),
          rows_(new Row[tree.nodes.size()]) {
        const double area = tree.root().box.surface_area();
        inverse_area_ = area > 0 ? 1 / area : 0;
    }

    /// Nothing when the tree is too deep.
    std::optional<Collapsed> run() {
        if (!plan(0, 0)) return std::nullopt;
        Collapsed result;
        result.cost = rows_[0][1];
        result.memory = Arena(measure(0));
        result.stack_size = plans_[0].stack_size;
        memory_ = result.memory.data();
        emit(0, 0);
        return result;
    }

private:
    /// Costs of a subtree with up to i places, from 1 on.
    using Row = std::array<float, N + 1>;

    struct Plan {
        std::uint32_t count;  ///< triangles
        std::uint32_t units;  ///< of memory, where it becomes a node
        int stack_size;       ///< likewise
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

    /// Fills plans and rows from the leaves up; false where it is too deep.
    bool plan(std::uint32_t index, int depth) {
        const Node& node = tree_.nodes[index];
        const float area = relative_area(node);
        Row& row = rows_[index];
        if (node.is_leaf()) {
            if (node.count > N)
                throw InvalidInput("WideTree: a leaf of the tree has more triangles than a block");
            plans_[index] = {node.count, 0, 0, true};
            row.fill(area * kBlockCost);
            return true;
        }
        if (depth == kDeepest) return false;
        bool left_done = false, right_done = false;
        const bool is_large = depth < 12;
        invoke_both(
            is_large, [&] { left_done = plan(node.left(), depth + 1); },
            [&] { right_done = plan(node.right(), depth + 1); });
        if (!left_done || !right_done) return false;

        const Row& left = rows_[node.left()];
        const Row& right = rows_[node.right()];
        const std::uint32_t count = plans_[node.left()].count + plans_[node.right()].count;
        Row shared;
        shared.fill(std::numeric_limits<float>::infinity());
        for (int k = 1; k < N; ++k) {
            for (int i = 1; i + k <= N; ++i)
                shared[i + k] = std::min(shared[i + k], left[k] + right[i]);
        }
        const float as_node = area * kNodeCost + shared[N];
        const float as_leaf =
            count <= N ? area * kBlockCost : std::numeric_limits<float>::infinity();
        plans_[index] = {count, 0, 0, as_leaf <= as_node};
        row[1] = std::min(as_leaf, as_node);
        for (int i = 2; i <= N; ++i) row[i] = std::min(row[i - 1], shared[i]);
        return true;
    }

    /// The children of the wide node that stands for this one: the root is a node even when all
    /// of the tree fits into a leaf, which then is its child.
    Children children_of(std::uint32_t index) const {
        Children children;
        if (plans_[index].is_leaf) {
            children.add(index);
        } else {
            share(index, N, children);
        }
        // Those that nothing hits need no place.
        const auto is_hidden = [&](std::uint32_t child) {
            return tree_.nodes[child].box.is_empty();
        };
        auto* begin = children.node.data();
        auto* end = std::remove_if(begin, begin + children.count, is_hidden);
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            const double area_a = tree_.nodes[a].box.surface_area();
            const double area_b = tree_.nodes[b].box.surface_area();
            return area_a != area_b ? area_a < area_b : a < b;
        });
        children.count = static_cast<int>(end - begin);
        return children;
    }

    /// Shares i places among what is below the node.
    void share(std::uint32_t index, int i, Children& children) const {
        const Row& left = rows_[tree_.nodes[index].left()];
        const Row& right = rows_[tree_.nodes[index].right()];
        int best = 1;
        for (int k = 2; k < i; ++k) {
            if (left[k] + right[i - k] < left[best] + right[i - best]) best = k;
        }
        place(tree_.nodes[index].left(), best, children);
        place(tree_.nodes[index].right(), i - best, children);
    }

    void place(std::uint32_t index, int i, Children& children) const {
        const Row& row = rows_[index];
        while (i > 1 && row[i] == row[i - 1]) --i;
        if (i == 1 || plans_[index].is_leaf) {
            children.add(index);
        } else {
            share(index, i, children);
        }
    }

    template <class Visit>
    void for_each(const Children& children, std::uint32_t count, const Visit& visit) {
        parallel_for(children.count, count > kSmallestTask ? 1 : N,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i) visit(i);
                     });
    }

    /// The bytes of the wide subtree.
    std::size_t measure(std::uint32_t index) {
        const Children children = children_of(index);
        for_each(children, plans_[index].count, [&](std::size_t i) {
            const std::uint32_t child = children.node[i];
            if (!plans_[child].is_leaf) measure(child);
        });
        std::size_t bytes = sizeof(WideNode<N>);
        for (int i = 0; i < children.count; ++i)
            bytes += bytes_of(children.node[i]);
        if (bytes / kReferenceUnit >= kLeafBit)
            throw InvalidInput("WideTree: more triangles than a wide tree can hold");
        plans_[index].units = units(bytes);
        // A walk goes on with one child and remembers the others.
        int deepest = 0;
        for (int i = 0; i < children.count; ++i)
            deepest = std::max(deepest, plans_[children.node[i]].stack_size);
        plans_[index].stack_size = deepest + std::max(children.count, 1) - 1;
        return bytes;
    }

    std::size_t bytes_of(std::uint32_t child) const {
        return plans_[child].is_leaf ? sizeof(TriangleBlock<N>)
                                     : plans_[child].units * kReferenceUnit;
    }

    void emit(std::uint32_t index, std::uint32_t place) {
        const Children children = children_of(index);
        auto* node = new (memory_ + byte_offset(place)) WideNode<N>;
        // Leaves follow their node, then come the subtrees.
        std::uint32_t next = place + units(sizeof(WideNode<N>));
        for (const bool leaves : {true, false}) {
            for (int i = 0; i < children.count; ++i) {
                const std::uint32_t child = children.node[i];
                if (plans_[child].is_leaf != leaves) continue;
                node->child[i] = next | (leaves ? kLeafBit : 0);
                next += units(bytes_of(child));
            }
        }
        write_boxes(children, *node);
        write_order(children, *node);
        for_each(children, plans_[index].count, [&](std::size_t i) {
            const std::uint32_t child = children.node[i];
            if (plans_[child].is_leaf) {
                emit_block(child, node->child[i]);
            } else {
                emit(child, node->child[i]);
            }
        });
    }

    void write_boxes(const Children& children, WideNode<N>& node) const {
        for (int i = 0; i < N; ++i) {
            const Box3f box = i < children.count ? tree_.nodes[children.node[i]].box : Box3f{};
            for (int k = 0; k < 3; ++k) {
                node.slabs[k].lo[i] = scale_ * box.lo[k];
                node.slabs[k].hi[i] = scale_ * box.hi[k];
            }
            if (i >= children.count) node.child[i] = 0;
        }
    }

    void write_order(const Children& children, WideNode<N>& node) const {
        std::fill(node.order, node.order + N, 0);
        for (int octant = 0; octant < 8; ++octant) {
            std::array<float, N> distance;
            std::array<std::uint32_t, N> slot;
            for (int i = 0; i < N; ++i) {
                slot[i] = i;
                if (i >= children.count) continue;
                const Vec3f center = tree_.nodes[children.node[i]].box.centroid();
                distance[i] = 0;
                for (int k = 0; k < 3; ++k)
                    distance[i] += (octant >> k & 1) ? -center[k] : center[k];
            }
            std::stable_sort(
                slot.begin(), slot.begin() + children.count,
                [&](std::uint32_t a, std::uint32_t b) { return distance[a] > distance[b]; });
            for (int i = 0; i < N; ++i) node.order[i] |= slot[i] << (4 * octant);
        }
    }

    void emit_block(std::uint32_t index, WideReference place) const {
        std::array<std::uint32_t, N> triangles;
        std::uint32_t count = 0;
        gather(index, triangles.data(), count);
        std::sort(triangles.begin(), triangles.begin() + count);
        count = static_cast<std::uint32_t>(
            std::unique(triangles.begin(), triangles.begin() + count) - triangles.begin());

        auto* block = new (memory_ + byte_offset(place)) TriangleBlock<N>;
        for (std::uint32_t i = 0; i < N; ++i) {
            const bool is_used = i < count && is_in_float_range(triangles[i]);
            block->triangle[i] = is_used ? triangles[i] : std::numeric_limits<std::uint32_t>::max();
            for (int corner = 0; corner < 3; ++corner) {
                for (int k = 0; k < 3; ++k)
                    block->corner[corner][k][i] =
                        is_used ? static_cast<float>(scale_ * mesh_.corner(triangles[i], corner)[k])
                                : std::numeric_limits<float>::quiet_NaN();
            }
        }
    }

    bool is_in_float_range(std::uint32_t triangle) const {
        bool inside = true;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3d& p = mesh_.corner(triangle, corner);
            for (int k = 0; k < 3; ++k) inside &= std::abs(p[k]) <= FLT_MAX;
        }
        return inside;
    }

    void gather(std::uint32_t index, std::uint32_t* triangles, std::uint32_t& count) const {
        const Node& node = tree_.nodes[index];
        if (node.is_leaf()) {
            for (const std::uint32_t triangle : tree_.primitives(node))
                triangles[count++] = triangle;
        } else {
            gather(node.left(), triangles, count);
            gather(node.right(), triangles, count);
        }
    }

    MeshView mesh_;
    const Tree& tree_;
    float scale_;
    std::unique_ptr<Plan[]> plans_;
    std::unique_ptr<Row[]> rows_;
    double inverse_area_;
    std::byte* memory_ = nullptr;
};

template <int N>
Collapsed collapse_to(MeshView mesh, const Tree& tree, float scale) {
    if (auto result = Collapser<N>(mesh, tree, scale).run()) return std::move(*result);
    const Tree flatter = bound_depth(tree, kDeepest - 32);
    return std::move(*Collapser<N>(mesh, flatter, scale).run());
}

}  // namespace

Collapsed collapse(MeshView mesh, const Tree& tree, int width, float scale) {
    if (tree.is_empty()) return {};
    switch (width) {
        case 16:
            return collapse_to<16>(mesh, tree, scale);
        case 8:
            return collapse_to<8>(mesh, tree, scale);
        default:
            return collapse_to<4>(mesh, tree, scale);
    }
}

}  // namespace boxwood
