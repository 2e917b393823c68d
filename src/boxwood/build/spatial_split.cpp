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
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxwood/build/block_sah.h"
#include "boxwood/build/clip.h"
#include "boxwood/build/object_split.h"
#include "boxwood/build/parts.h"
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

/// The references [begin, end), with room up to limit for those that splits will add.
struct Range {
    std::uint32_t begin = 0, end = 0, limit = 0;
    WideBox box;

    std::uint32_t count() const { return end - begin; }
    std::uint32_t room() const { return limit - end; }
};

struct Halves {
    Range left, right;
};

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
                      memory_.size() / sizeof(Reference)) {
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
    std::span<const Reference> references(const Range& range) const {
        return {references_.data() + range.begin, range.count()};
    }

    void build_part(TreePart& part, Range range, int depth) {
        if (range.count() <= kSmallestTask || is_for_blocks(range))
            return build_node(part.nodes, 0, range, depth);
        if (const auto halves = cut(range, depth)) {
            build_children(part, *halves, depth);
        } else {
            make_leaf(part.nodes[0], range);
        }
    }

    void build_children(TreePart& part, const Halves& halves, int depth) {
        part.left = std::make_unique<TreePart>();
        part.right = std::make_unique<TreePart>();
        invoke_both(
            halves.left.count() + halves.right.count() > kSmallestTask,
            [&] { build_part(*part.left, halves.left, depth + 1); },
            [&] { build_part(*part.right, halves.right, depth + 1); });
        // Clipping makes the children smaller than the set was.
        part.nodes[0].box = merged(part.left->nodes[0].box, part.right->nodes[0].box);
    }

    void build_node(std::vector<Node>& nodes, std::uint32_t index, Range range, int depth) {
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
    std::optional<Halves> cut(Range& range, int& depth) {
        for (;; ++depth) {
            if (range.count() == 1) return std::nullopt;
            if (range.box.is_empty() || depth >= kDeepestSahSplit) {
                if (range.count() <= options_.largest_leaf) return std::nullopt;
                return halve(range);
            }
            const bool is_few = range.count() <= kFew;
            const std::uint32_t bins = range.count() < 64 ? kFewBins : kMostBins;
            const Grid grid(is_few ? WideBox() : centre_bounds(range), static_cast<int>(bins));
            Ranks ranks;
            const ObjectSplit object = is_few
                                           ? best_swept_split(references(range), sah_, ranks)
                                           : best_binned_split(references(range), sah_, grid, bins);

            SpatialSplit spatial;
            const Grid space(range.box, kSpatialBins);
            if (range.room() > 0 && (object.axis < 0 || overlap(object) > least_overlap_))
                spatial = best_spatial_split(mesh_, references(range), sah_, space, range.room(),
                                             object.cost);

            if (is_leaf_cheaper(range, std::min(object.cost, spatial.cost))) return std::nullopt;
            if (spatial.axis < 0) {
                if (object.axis < 0) return halve(range);
                return is_few ? split_by_rank(range, ranks, object)
                              : split_by_bin(range, grid, object);
            }
            const Halves halves = split_space(range, space, spatial);
            if (halves.left.count() > 0 && halves.right.count() > 0) return halves;
            range = halves.left.count() == 0 ? halves.right : halves.left;
        }
    }

    /// Whether it is too small for parts of it to overlap by more than the least, so that no
    /// triangle will be split.
    bool is_for_blocks(const Range& range) const {
        return options_.block > 0 && !range.box.is_empty() &&
               sah_.half_area(range.box) <= least_overlap_;
    }

    void build_blocks(std::vector<Node>& nodes, std::uint32_t index, const Range& range,
                      int depth) {
        // In the order of the mesh, in which runs are.
        std::vector<std::uint64_t> keys(range.count()), sorted(range.count());
        for (std::uint32_t i = 0; i < range.count(); ++i)
            keys[i] = std::uint64_t{references(range)[i].primitive()} << 32 | (range.begin + i);
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

    WideBox centre_bounds(const Range& range) const {
        WideBox bounds;
        for (const Reference& reference : references(range))
            bounds.extend(sah_.centre(reference.box()));
        return bounds;
    }

    float overlap(const ObjectSplit& split) const {
        const WideBox shared = intersection(split.left, split.right);
        return shared.is_empty() ? 0 : sah_.half_area(shared);
    }

    bool is_leaf_cheaper(const Range& range, float split_cost) const {
        if (range.count() > options_.largest_leaf) return false;
        const double area = sah_.half_area(range.box);
        return options_.block_cost * sah_.cost(range.box, range.count()) <=
               options_.node_cost * area + options_.block_cost * split_cost;
    }

    void make_leaf(Node& node, const Range& range) {
        node = {range.box.box(), range.begin, range.count()};
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            tree_.order[i] = references_[i].primitive();
    }

    /// Both halves, the right one moved so that each has a share of the room that is its share of
    /// the cost: where rays are expected to have the most to do, parts help the most.
    Halves with_shared_room(Range left, Range right, std::uint32_t limit) {
        const std::uint32_t room = limit - left.begin - left.count() - right.count();
        const double left_cost = sah_.cost(left.box, left.count());
        const double both = left_cost + sah_.cost(right.box, right.count());
        const auto left_room =
            both > 0 ? static_cast<std::uint32_t>(room * (left_cost / both)) : room / 2;
        left.limit = left.end + left_room;
        const std::uint32_t begin = left.limit, end = begin + right.count();
        // Their order is free, so only those move that are in the way.
        const auto first = references_.begin();
        if (begin > right.begin)
            std::copy(first + right.begin, first + std::min(begin, right.end),
                      first + std::max(right.end, begin));
        else
            std::copy(first + std::max(end, right.begin), first + right.end, first + begin);
        right.begin = begin;
        right.end = end;
        right.limit = limit;
        return {left, right};
    }

    /// Moves those of which it holds to the front of [begin, end) and tells where they end: an
    /// unpredictable branch would cost more than the moves.
    template <class Predicate>
    std::uint32_t partition(std::uint32_t begin, std::uint32_t end, const Predicate& holds) {
        std::uint32_t middle = begin;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Reference reference = references_[i];
            references_[i] = references_[middle];
            references_[middle] = reference;
            middle += holds(reference);
        }
        return middle;
    }

    Halves split_by_bin(const Range& range, const Grid& grid, const ObjectSplit& split) {
        const auto is_left = [&](const Reference& reference) {
            return grid.bins_of(sah_.centre(reference.box()))[split.axis] <
                   static_cast<int>(split.place);
        };
        return cut_at(range, partition(range.begin, range.end, is_left), split.left, split.right);
    }

    Halves split_by_rank(const Range& range, const Ranks& ranks, const ObjectSplit& split) {
        std::array<Reference, kFew> sorted;
        for (std::uint32_t i = 0; i < range.count(); ++i)
            sorted[ranks[i]] = references_[range.begin + i];
        std::copy_n(sorted.begin(), range.count(), references_.begin() + range.begin);
        return cut_at(range, range.begin + split.place, split.left, split.right);
    }

    Halves halve(const Range& range) {
        const int axis = range.box.is_empty() ? 0 : centre_bounds(range).box().longest_axis();
        const std::uint32_t middle = range.begin + (range.count() + 1) / 2;
        std::nth_element(
            references_.begin() + range.begin, references_.begin() + middle,
            references_.begin() + range.end, [&](const Reference& a, const Reference& b) {
                const float a_place = sah_.centre(a.box())[axis];
                const float b_place = sah_.centre(b.box())[axis];
                return a_place != b_place ? a_place < b_place : a.primitive() < b.primitive();
            });
        WideBox left, right;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            (i < middle ? left : right).extend(references_[i].box());
        return cut_at(range, middle, left, right);
    }

    Halves cut_at(const Range& range, std::uint32_t middle, const WideBox& left,
                  const WideBox& right) {
        return with_shared_room({range.begin, middle, 0, left}, {middle, range.end, 0, right},
                                range.limit);
    }

    Halves split_space(const Range& range, const Grid& space, const SpatialSplit& split);
    void unsplit_if_cheaper(Reference& left_part, Reference& right_part, Range& left,
                            Range& right) const;

    MeshView mesh_;
    SpatialSplitOptions options_;
    Sah sah_;
    Arena memory_;
    std::span<Reference> references_;
    Tree tree_;
    Range hittable_, empty_;
    float least_overlap_ = 0;
};

/// Gives both parts of a triangle to the side where that is cheaper than a reference on each, which
/// the paper calls unsplitting; the other part becomes empty.
void SpatialSplitBuilder::unsplit_if_cheaper(Reference& left_part, Reference& right_part,
                                             Range& left, Range& right) const {
    const bool is_left = !left_part.box().is_empty(), is_right = !right_part.box().is_empty();
    if (is_left && is_right) {
        const WideBox whole = merged(left_part.box(), right_part.box());
        const WideBox wider_left = merged(left.box, whole), wider_right = merged(right.box, whole);
        const float both = sah_.cost(left.box, left.end) + sah_.cost(right.box, right.end);
        const float only_left =
            sah_.cost(wider_left, left.end) + sah_.cost(right.box, right.end - 1);
        const float only_right =
            sah_.cost(left.box, left.end - 1) + sah_.cost(wider_right, right.end);
        if (only_left < both && only_left <= only_right && right.end > 1) {
            left_part = {whole, left_part};
            right_part = {WideBox(), right_part};
            left.box = wider_left;
        } else if (only_right < both && left.end > 1) {
            right_part = {whole, right_part};
            left_part = {WideBox(), left_part};
            right.box = wider_right;
        }
    }
    if (left_part.box().is_empty()) --left.end;
    if (right_part.box().is_empty()) --right.end;
}

/// A triangle across the plane goes to both sides in two parts, but where that doesn't pay.
Halves SpatialSplitBuilder::split_space(const Range& range, const Grid& space,
                                        const SpatialSplit& split) {
    // Left of the plane, across it, right of it.
    Range left, right;
    left.begin = range.begin;
    left.end = partition(range.begin, range.end, [&](const Reference& reference) {
        const Eigen::Array4i bins = space.bins_of(reference.box().lo);
        return space.last_bins_of(reference.box().hi, bins)[split.axis] < split.bin;
    });
    right.begin = partition(left.end, range.end, [&](const Reference& reference) {
        return space.bins_of(reference.box().lo)[split.axis] < split.bin;
    });
    right.end = range.end;
    for (std::uint32_t i = left.begin; i < left.end; ++i) left.box.extend(references_[i].box());
    for (std::uint32_t i = right.begin; i < right.end; ++i) right.box.extend(references_[i].box());

    // The left parts stay in place, the right parts wait behind the end.
    const float plane = space.face(split.axis, split.bin);
    const std::uint32_t cut = right.begin - left.end;
    WideBox left_box = left.box, right_box = right.box;
    for (std::uint32_t k = 0; k < cut; ++k) {
        const Reference whole = references_[left.end + k];
        const WideBox& box = whole.box();
        const int axis = split.axis;
        Reference& left_part = references_[left.end + k];
        Reference& right_part = references_[range.end + k];
        left_part = {clipped_box(mesh_, whole.primitive(), box, axis, box.lo[axis], plane), whole};
        right_part = {clipped_box(mesh_, whole.primitive(), box, axis, plane, box.hi[axis]), whole};
        if (left_part.box().is_empty() && right_part.box().is_empty()) left_part = whole;
        if (!left_part.box().is_empty()) left_box.extend(left_part.box());
        if (!right_part.box().is_empty()) right_box.extend(right_part.box());
    }

    // The sides as they are when all are split; each that isn't changes them for the next.
    Range all_left = {0, left.count() + cut, 0, left_box};
    Range all_right = {0, right.count() + cut, 0, right_box};
    std::uint32_t left_end = left.end, right_end = range.end;
    for (std::uint32_t k = 0; k < cut; ++k) {
        Reference left_part = references_[left.end + k];
        Reference right_part = references_[range.end + k];
        unsplit_if_cheaper(left_part, right_part, all_left, all_right);
        if (!left_part.box().is_empty()) {
            left.box.extend(left_part.box());
            references_[left_end++] = left_part;
        }
        if (!right_part.box().is_empty()) {
            right.box.extend(right_part.box());
            references_[right_end++] = right_part;
        }
    }
    left.end = left_end;
    right.end = right_end;
    return with_shared_room(left, right, range.limit);
}

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
