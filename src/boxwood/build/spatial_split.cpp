// SPDX-License-Identifier: Apache-2.0
// Top-down construction as in binned_sah.cpp, with a second kind of cut. An object split gives each
// triangle to one side, and where large triangles are among small ones the sides' boxes overlap. A
// spatial split cuts space by a plane: a triangle across it goes to both sides, each with a box
// around its part alone. Both are rated by the surface area heuristic; spatial splits are tried
// only where the overlap is worth it, and within a budget of additional references. Source: Stich,
// Friedrich and Dietrich, "Spatial Splits in Bounding Volume Hierarchies", High Performance
// Graphics, 2009. Explained in docs/algorithms/spatial_split.md.
#include "boxwood/build/spatial_split.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxwood/build/block_sah.h"
#include "boxwood/build/object_split.h"
#include "boxwood/build/parts.h"
#include "boxwood/build/reference_divider.h"
#include "boxwood/build/runs.h"
#include "boxwood/build/slots.h"
#include "boxwood/build/spatial_bins.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/huge_pages.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/radix_sort.h"

namespace boxwood {

namespace {

constexpr std::uint32_t kFewBins = 16;
/// Below this depth ranges are halved, so that no input makes a deep tree.
constexpr int kDeepestSahSplit = 40;

std::size_t most_references(std::size_t triangles, double replication) {
    const double most = std::floor(replication * static_cast<double>(triangles));
    // Nodes, two a reference, are counted in 32 bits.
    return std::max(triangles, static_cast<std::size_t>(std::min(most, 0x1p30)));
}

class SpatialSplitBuilder {
public:
    SpatialSplitBuilder(MeshView mesh, std::span<const Box3f> boxes,
                        const SpatialSplitOptions& options)
        : mesh_(mesh),
          options_(options),
          sah_(unit_scale(boxes), std::countr_zero(options.leaf_block)),
          memory_(most_references(boxes.size(), options.replication) * sizeof(Reference)),
          references_(reinterpret_cast<Reference*>(memory_.data()),
                      memory_.size() / sizeof(Reference)),
          divider_(mesh, sah_, references_) {
        resize_on_huge_pages(tree_.order, references_.size());
        std::fill(tree_.order.begin(), tree_.order.end(), kUnusedPlace);
        // Boxes that nothing hits stand apart at the end and trouble no split.
        std::uint32_t begin = 0, end = capacity();
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            references_[boxes[i].is_empty() ? --end : begin++] = Reference(boxes[i], i);
        hittable_ = {0, begin, end, {}};
        for (std::uint32_t i = 0; i < begin; ++i) hittable_.box.extend(references_[i].box());
        empty_ = {end, capacity(), capacity(), {}};
        least_overlap_ = static_cast<float>(options.least_overlap) * sah_.half_area(hittable_.box);
    }

    Tree build() && {
        TreePart root;
        if (empty_.count() == 0) {
            build_part(root, hittable_, 0);
        } else if (hittable_.count() == 0) {
            build_part(root, empty_, 0);
        } else {
            build_children(root, {hittable_, empty_}, 0);
        }
        memory_ = {};
        tree_.nodes = joined(std::move(root));
        close_gaps_in_order(tree_);
        return std::move(tree_);
    }

private:
    std::uint32_t capacity() const { return static_cast<std::uint32_t>(references_.size()); }

    void build_part(TreePart& part, ReferenceRange range, int depth) {
        if (range.count() <= kSmallestTask || is_for_blocks(range))
            return build_node(part.nodes, 0, range, depth);
        if (const auto halves = cut(range, depth)) {
            build_children(part, *halves, depth);
        } else {
            make_leaf(part.nodes[0], range);
        }
    }

    void build_children(TreePart& part, const ReferenceHalves& halves, int depth) {
        part.left = std::make_unique<TreePart>();
        part.right = std::make_unique<TreePart>();
        invoke_both(
            halves.left.count() + halves.right.count() > kSmallestTask,
            [&] { build_part(*part.left, halves.left, depth + 1); },
            [&] { build_part(*part.right, halves.right, depth + 1); });
        // Clipping makes the children smaller than the set was.
        part.nodes[0].box = merged(part.left->nodes[0].box, part.right->nodes[0].box);
    }

    void build_node(std::vector<Node>& nodes, std::uint32_t index, ReferenceRange range,
                    int depth) {
        if (is_for_blocks(range)) return build_blocks(nodes, index, range, depth);
        const auto halves = cut(range, depth);
        if (!halves) return make_leaf(nodes[index], range);
        const auto first = static_cast<std::uint32_t>(nodes.size());
        nodes[index].first = first;
        nodes.resize(first + 2);
        build_node(nodes, first, halves->left, depth + 1);
        build_node(nodes, first + 1, halves->right, depth + 1);
        nodes[index].box = merged(nodes[first].box, nodes[first + 1].box);
    }

    /// How to cut the range, or nothing when it becomes a leaf. Clipping may show that all of it is
    /// on one side of a plane: then the range, and the depth, are what the next cut starts from.
    std::optional<ReferenceHalves> cut(ReferenceRange& range, int& depth) {
        for (;; ++depth) {
            if (range.count() == 1) return std::nullopt;
            if (range.box.is_empty() || depth >= kDeepestSahSplit) {
                if (range.count() <= options_.largest_leaf) return std::nullopt;
                return divider_.halve(range);
            }
            const bool is_few = range.count() <= kFew;
            const std::uint32_t bins = range.count() < 64 ? kFewBins : kMostBins;
            const Grid grid(is_few ? WideBox() : divider_.centre_bounds(range),
                            static_cast<int>(bins));
            Ranks ranks;
            const ObjectSplit object =
                is_few ? best_swept_split(divider_.in(range), sah_, ranks)
                       : best_binned_split(divider_.in(range), sah_, grid, bins);

            SpatialSplit spatial;
            const Grid space(range.box, kSpatialBins);
            if (range.room() > 0 && (object.axis < 0 || overlap(object) > least_overlap_))
                spatial = best_spatial_split(mesh_, divider_.in(range), sah_, space, range.room(),
                                             object.cost);

            if (is_leaf_cheaper(range, std::min(object.cost, spatial.cost))) return std::nullopt;
            if (spatial.axis < 0) {
                if (object.axis < 0) return divider_.halve(range);
                return is_few ? divider_.split_by_rank(range, ranks, object)
                              : divider_.split_by_bin(range, grid, object);
            }
            const ReferenceHalves halves = divider_.split_space(range, space, spatial);
            if (halves.left.count() > 0 && halves.right.count() > 0) return halves;
            range = halves.left.count() == 0 ? halves.right : halves.left;
        }
    }

    /// Whether it is too small for parts of it to overlap by more than the least, so that no
    /// triangle will be split.
    bool is_for_blocks(const ReferenceRange& range) const {
        return options_.block > 0 && !range.box.is_empty() &&
               sah_.half_area(range.box) <= least_overlap_;
    }

    void build_blocks(std::vector<Node>& nodes, std::uint32_t index, const ReferenceRange& range,
                      int depth) {
        // In the order of the mesh, in which runs are.
        std::vector<std::uint64_t> keys(range.count()), sorted(range.count());
        for (std::uint32_t i = 0; i < range.count(); ++i)
            keys[i] = std::uint64_t{divider_.in(range)[i].primitive()} << 32 | (range.begin + i);
        radix_sort(keys, sorted, 32, std::bit_width(mesh_.faces.size()));
        std::vector<Box3f> boxes(range.count());
        std::vector<std::uint32_t> triangles(range.count());
        for (std::uint32_t i = 0; i < range.count(); ++i) {
            boxes[i] = references_[static_cast<std::uint32_t>(sorted[i])].box().box();
            triangles[i] = static_cast<std::uint32_t>(sorted[i] >> 32);
        }
        const TriangleRuns runs(boxes, triangles, options_.run);
        Tree blocks = runs.over_triangles(
            build_block_sah(runs.boxes(), {.block = options_.block / options_.run,
                                           .deepest_sah_split = kDeepestSahSplit - depth}));
        for (std::uint32_t i = 0; i < range.count(); ++i)
            tree_.order[range.begin + i] = triangles[blocks.order[i]];
        const auto offset = static_cast<std::uint32_t>(nodes.size()) - 1;
        for (Node& node : blocks.nodes) node.first += node.is_leaf() ? range.begin : offset;
        nodes[index] = blocks.nodes[0];
        nodes.insert(nodes.end(), blocks.nodes.begin() + 1, blocks.nodes.end());
    }

    float overlap(const ObjectSplit& split) const {
        const WideBox shared = intersection(split.left, split.right);
        return shared.is_empty() ? 0 : sah_.half_area(shared);
    }

    bool is_leaf_cheaper(const ReferenceRange& range, float split_cost) const {
        if (range.count() > options_.largest_leaf) return false;
        const double area = sah_.half_area(range.box);
        return options_.block_cost * sah_.cost(range.box, range.count()) <=
               options_.node_cost * area + options_.block_cost * split_cost;
    }

    void make_leaf(Node& node, const ReferenceRange& range) {
        node = {range.box.box(), range.begin, range.count()};
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            tree_.order[i] = references_[i].primitive();
    }

    MeshView mesh_;
    SpatialSplitOptions options_;
    Sah sah_;
    Arena memory_;
    std::span<Reference> references_;
    ReferenceDivider divider_;
    Tree tree_;
    ReferenceRange hittable_, empty_;
    float least_overlap_ = 0;
};

}  // namespace

Tree build_spatial_split(MeshView mesh, const SpatialSplitOptions& options) {
    if (options.largest_leaf < 1 || !std::has_single_bit(options.leaf_block) ||
        !(options.replication >= 1 && options.replication <= 4))
        throw InvalidInput(
            "build_spatial_split: expected leaves of at least 1, blocks of a power of two and a "
            "replication of 1 to 4");
    if (options.run != 1 && options.run != 2 && options.run != 4)
        throw InvalidInput("build_spatial_split: expected runs of 1, 2 or 4");
    if (options.block > 256 || (options.block > 0 && options.block < options.run))
        throw InvalidInput(
            "build_spatial_split: expected blocks of no less than a run and of up to 256, or of 0");
    if (mesh.faces.empty()) return {};
    return SpatialSplitBuilder(mesh, triangle_boxes(mesh), options).build();
}

}  // namespace boxwood
