// SPDX-License-Identifier: Apache-2.0
// Binned SAH for trees whose leaves are blocks of triangles that are tested at once. What differs
// from binned_sah.cpp: a leaf costs a block however full it is; the boxes of the two sides of a cut
// are those of the bins; the pass that divides the references is free of branches and gathers the
// bounds of the centroids on either side. So a level is two short passes, to bin and to divide.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on
// Interactive Ray Tracing, 2007. Explained in docs/algorithms/block_sah.md.
#include "boxwood/build/block_sah.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <memory>
#include <utility>
#include <vector>

#include "boxwood/build/bins.h"
#include "boxwood/build/parts.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/arena.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

constexpr int kDeepestSahSplit = 40;
/// Ranges of fewer references are built by the task that comes to them.
constexpr std::uint32_t kSmallestTask = 4096;
/// References that a task makes, and that one bins, where there are more.
constexpr std::uint32_t kPiece = 1 << 13;
constexpr std::uint32_t kBinningPiece = 1 << 15;
/// Ranges of fewer do with half the bins.
constexpr std::uint32_t kMany = 1024;

/// References side by side, and bounds of their boxes and centers.
struct Range {
    std::uint32_t begin = 0, end = 0;
    Box4 bounds = Box4::empty();
    Box4 centers = Box4::empty();

    std::uint32_t count() const { return end - begin; }
    void add(const BlockReference& reference) {
        bounds.extend(reference.box);
        centers.extend(reference.center());
    }
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;  ///< -1: there is none
    int bin = 0;    ///< the first bin of the right side
};

class BlockSahBuilder {
public:
    /// box_of(i) is the box of primitive i.
    template <class BoxOf>
    BlockSahBuilder(std::uint32_t count, const BoxOf& box_of, const BlockSahOptions& options)
        : block_(options.block),
          deepest_sah_split_(options.deepest_sah_split),
          memory_(count * sizeof(BlockReference)) {
        references_ = reinterpret_cast<BlockReference*>(memory_.data());
        tree_.order.resize(count);
        make_references(count, box_of);
    }

    Tree build() && {
        TreePart root;
        if (all_.count() == tree_.order.size()) {
            build_part(root, all_, 0);
        } else {
            // What nothing hits is kept apart.
            root.right = std::make_unique<TreePart>();
            build_hidden(root.right->nodes, 0, all_.end, tree_.order.size());
            if (all_.count() == 0) {
                TreePart hidden = std::move(*root.right);
                root = std::move(hidden);
            } else {
                root.left = std::make_unique<TreePart>();
                build_part(*root.left, all_, 1);
                root.nodes[0].box = merged(root.left->nodes[0].box, root.right->nodes[0].box);
            }
        }
        memory_ = {};
        tree_.nodes = joined(std::move(root));
        return std::move(tree_);
    }

private:
    template <class BoxOf>
    void make_references(std::uint32_t count, const BoxOf& box_of) {
        std::vector<Range> pieces((count + kPiece - 1) / kPiece);
        parallel_for(pieces.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t p = first; p < last; ++p) {
                const auto begin = static_cast<std::uint32_t>(p * kPiece);
                pieces[p] = make_piece(begin, std::min(count, begin + kPiece), box_of);
            }
        });
        for (const Range& piece : pieces) {
            all_.bounds.extend(piece.bounds);
            all_.centers.extend(piece.centers);
            // The hidden ones of the pieces so far go behind it.
            for (std::uint32_t i = piece.begin; i < piece.end; ++i, ++all_.end) {
                if (all_.end != i) std::swap(references_[all_.end], references_[i]);
            }
        }
        scale_ = unit_scale(all_.bounds.box());
    }

    /// What the range returned leaves out at its end nothing can hit.
    template <class BoxOf>
    Range make_piece(std::uint32_t begin, std::uint32_t end, const BoxOf& box_of) {
        Range piece;
        piece.begin = piece.end = begin;
        std::uint32_t hidden = end;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box3f box = box_of(i);
            references_[is_finite(box) ? piece.end++ : --hidden] = BlockReference(box, i);
        }
        // Apart, since reading a register's worth of what was just written in parts is slow.
        for (std::uint32_t i = begin; i < piece.end; ++i) piece.add(references_[i]);
        return piece;
    }

    static bool is_finite(const Box3f& box) {
        return (box.lo.array() >= -FLT_MAX && box.hi.array() <= FLT_MAX &&
                box.lo.array() <= box.hi.array())
            .all();
    }

    void build_part(TreePart& part, const Range& range, int depth) {
        if (range.count() <= kSmallestTask) {
            part.nodes.reserve(range.count() / 4 + 1);
            return build_node(part.nodes, 0, range, depth);
        }
        part.nodes[0].box = range.bounds.box();
        part.left = std::make_unique<TreePart>();
        part.right = std::make_unique<TreePart>();
        Range left, right;
        divide(range, depth, left, right);
        invoke_both(
            true, [&] { build_part(*part.left, left, depth + 1); },
            [&] { build_part(*part.right, right, depth + 1); });
    }

    void build_node(std::vector<Node>& nodes, std::uint32_t index, const Range& range, int depth) {
        nodes[index].box = range.bounds.box();
        if (range.count() <= block_) return make_leaf(nodes[index], range);
        const auto first = static_cast<std::uint32_t>(nodes.size());
        nodes[index].first = first;
        nodes.resize(first + 2);
        Range left, right;
        divide(range, depth, left, right);
        build_node(nodes, first, left, depth + 1);
        build_node(nodes, first + 1, right, depth + 1);
    }

    void make_leaf(Node& node, const Range& range) {
        node.first = range.begin;
        node.count = range.count();
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            tree_.order[i] = references_[i].primitive();
    }

    void divide(const Range& range, int depth, Range& left, Range& right) {
        Bins bins(range.count() < kMany ? Bins::kMost / 2 : Bins::kMost);
        const Binning binning(range.centers, bins.size);
        Split split;
        if (depth < deepest_sah_split_) {
            bin(range, binning, bins);
            split = best_split(binning, bins);
        }
        if (split.axis < 0) return halve(range, left, right);
        std::uint32_t count = 0;
        for (int i = 0; i < bins.size; ++i) {
            (i < split.bin ? left : right).bounds.extend(bins.box[split.axis][i]);
            if (i < split.bin) count += bins.count[i][split.axis];
        }
        left.begin = range.begin;
        left.end = right.begin = range.begin + count;
        right.end = range.end;
        partition(range, binning, split, left, right);
    }

    void bin(const Range& range, const Binning& binning, Bins& bins) const {
        if (range.count() < 2 * kBinningPiece) return bin(range.begin, range.end, binning, bins);
        std::vector<Bins> parts((range.count() + kBinningPiece - 1) / kBinningPiece, bins);
        parallel_for(parts.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t p = first; p < last; ++p) {
                const auto begin = range.begin + static_cast<std::uint32_t>(p * kBinningPiece);
                bin(begin, std::min(begin + kBinningPiece, range.end), binning, parts[p]);
            }
        });
        for (const Bins& part : parts) bins.add(part);
    }

    void bin(std::uint32_t begin, std::uint32_t end, const Binning& binning, Bins& bins) const {
        // A copy of the binning stays in registers, whatever is written to.
        const auto add = [binning, references = references_](std::uint32_t i, Bins& to) {
            const BlockReference& reference = references[i];
            to.add(reference.box, binning.place(reference.center()).cast<int>());
        };
        std::uint32_t i = begin;
        if (end - begin >= kMany) {
            // Neighbours are in the same bins, and one waits for the other's update.
            Bins others(bins.size);
            for (; i + 1 < end; i += 2) {
                add(i, bins);
                add(i + 1, others);
            }
            bins.add(others);
        }
        for (; i < end; ++i) add(i, bins);
    }

    /// What the two sides of each border cost, all three axes at once: each has a lane. Then the
    /// least of it, since nobody could predict on the way whether the next border is better.
    Split best_split(const Binning& binning, const Bins& bins) const {
        std::array<Eigen::Array4f, Bins::kMost> cost;
        Side right;
        for (int i = bins.size - 1; i > 0; --i) {
            right.add(bins, i);
            cost[i] = cost_of(right);
        }
        Side left;
        Eigen::Array4f least = Eigen::Array4f::Constant(Split().cost);
        for (int i = 1; i < bins.size; ++i) {
            left.add(bins, i - 1);
            cost[i] += cost_of(left);
            least = least.min(cost[i]);
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!binning.is_flat(axis) && least[axis] < best.cost) best = {least[axis], axis};
        }
        while (best.axis >= 0 && cost[++best.bin][best.axis] != best.cost) {
        }
        return best;
    }

    /// What is on one side of a border, along each axis.
    struct Side {
        Box4 box[3] = {Box4::empty(), Box4::empty(), Box4::empty()};
        Eigen::Array4i count = Eigen::Array4i::Zero();

        void add(const Bins& bins, int i) {
            for (int axis = 0; axis < 3; ++axis) box[axis].extend(bins.box[axis][i]);
            count += bins.count[i];
        }
    };

    /// Half the area, scaled so that it neither overflows nor vanishes, times the blocks to fill.
    Eigen::Array4f cost_of(const Side& side) const {
        Eigen::Array44f extent;  // a column an axis of the border
        for (int axis = 0; axis < 3; ++axis)
            extent.col(axis) = scale_ * side.box[axis].hi - scale_ * side.box[axis].lo;
        extent.col(3).setZero();
        extent.transposeInPlace();
        const Eigen::Array4f x = extent.col(0), y = extent.col(1), z = extent.col(2);
        const Eigen::Array4f count = side.count.cast<float>() + static_cast<float>(block_ - 1);
        const Eigen::Array4f blocks =
            (count / static_cast<float>(block_)).cast<int>().cast<float>();
        return (x * y + y * z + z * x) * blocks;
    }

    /// Without a branch on the side, which nobody could predict: each reference changes places with
    /// the first one of the right side, and on the left that side begins one later.
    void partition(const Range& range, const Binning& binning, const Split& split, Range& left,
                   Range& right) {
        const auto is_right = [binning, split](const Eigen::Array4f& center) {
            return binning.place(center)[split.axis] >= static_cast<float>(split.bin);
        };
        Box4 centers[2][2] = {{Box4::empty(), Box4::empty()}, {Box4::empty(), Box4::empty()}};
        BlockReference* middle = references_ + range.begin;
        BlockReference* end = references_ + range.end;
        int turn = 0;
        for (BlockReference* r = middle; r != end; ++r) {
            const BlockReference reference = *r;
            const Eigen::Array4f center = reference.center();
            const bool side = is_right(center);
            centers[turn][side].extend(center);
            turn ^= 1;
            *r = *middle;
            *middle = reference;
            middle += !side;
        }
        left.centers = centers[0][0];
        left.centers.extend(centers[1][0]);
        right.centers = centers[0][1];
        right.centers.extend(centers[1][1]);
    }

    void halve(const Range& range, Range& left, Range& right) const {
        left.begin = range.begin;
        left.end = right.begin = range.begin + (range.count() + 1) / 2;
        right.end = range.end;
        for (Range* side : {&left, &right}) {
            for (std::uint32_t i = side->begin; i < side->end; ++i) side->add(references_[i]);
        }
    }

    /// A balanced tree over references from begin to end.
    void build_hidden(std::vector<Node>& nodes, std::uint32_t index, std::uint32_t begin,
                      std::uint32_t end) {
        if (end - begin <= block_) {
            Range range;
            range.begin = begin;
            range.end = end;
            make_leaf(nodes[index], range);
            for (std::uint32_t i = begin; i < end; ++i)
                nodes[index].box.extend(references_[i].box.box());
            return;
        }
        const auto first = static_cast<std::uint32_t>(nodes.size());
        nodes[index].first = first;
        nodes.resize(first + 2);
        const std::uint32_t middle = begin + (end - begin + 1) / 2;
        build_hidden(nodes, first, begin, middle);
        build_hidden(nodes, first + 1, middle, end);
        nodes[index].box = merged(nodes[first].box, nodes[first + 1].box);
    }

    std::uint32_t block_;
    int deepest_sah_split_;
    Arena memory_;
    BlockReference* references_ = nullptr;
    Range all_;  ///< that something can hit
    float scale_ = 1;
    Tree tree_;
};

void check(const BlockSahOptions& options) {
    if (options.block < 1 || options.block > 256)
        throw InvalidInput("build_block_sah: expected blocks of 1 to 256");
    if (options.deepest_sah_split > kDeepestSahSplit)
        throw InvalidInput("build_block_sah: expected cuts by SAH down to a depth of 40 at most");
}

}  // namespace

Tree build_block_sah(std::span<const Box3f> boxes, const BlockSahOptions& options) {
    check(options);
    if (boxes.empty()) return {};
    return BlockSahBuilder(
               static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return boxes[i]; },
               options)
        .build();
}

Tree build_block_sah(MeshView mesh, const BlockSahOptions& options) {
    check(options);
    if (mesh.faces.empty()) return {};
    return BlockSahBuilder(
               static_cast<std::uint32_t>(mesh.faces.size()),
               [&](std::uint32_t i) { return triangle_box(mesh, i); }, options)
        .build();
}

}  // namespace boxwood
