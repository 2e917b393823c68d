// SPDX-License-Identifier: Apache-2.0
// Top-down construction by the surface area heuristic (SAH): a random line that hits a box hits a
// smaller one inside it with a chance that is the ratio of their surface areas. So a split costs
// area(left) * n(left) + area(right) * n(right). Sorting the primitives into a few bins along each
// axis and trying only the borders between bins finds nearly the best split in linear time.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", IEEE Symposium on
// Interactive Ray Tracing, 2007. Explained in docs/algorithms/binned_sah.md.
#include "boxwood/build/binned_sah.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "boxwood/build/slots.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

constexpr int kMostBins = 32;
/// Below this depth ranges are halved, so that no input makes a deep tree.
constexpr int kDeepestSahSplit = 40;

/// A box with a fourth, idle coordinate, so that its corners fill SIMD registers.
struct PaddedBox {
    Eigen::Array4f lo = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array4f hi = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());

    PaddedBox() = default;
    explicit PaddedBox(const Box3f& box) {
        lo << box.lo.array(), 0;
        hi << box.hi.array(), 0;
    }

    Box3f box() const { return {lo.head<3>(), hi.head<3>()}; }
    bool is_empty() const { return !(lo.x() <= hi.x()); }

    void extend(const PaddedBox& other) {
        lo = lo.min(other.lo);
        hi = hi.max(other.hi);
    }
    void extend(const Eigen::Array4f& point) {
        lo = lo.min(point);
        hi = hi.max(point);
    }
};

struct Reference {
    PaddedBox box;
    std::uint32_t primitive = 0;
};

struct Bin {
    PaddedBox box;
    std::uint32_t count = 0;

    void add(const Bin& other) {
        box.extend(other.box);
        count += other.count;
    }
};

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;  ///< -1: there is none
    int bin = 0;    ///< the first bin of the right side
};

/// Tells the bin of a primitive by its centroid, along each axis.
class Binning {
public:
    Binning(const PaddedBox& centroid_bounds, int bins) : lo_(centroid_bounds.lo), bins_(bins) {
        const Eigen::Array4f extent = centroid_bounds.hi - centroid_bounds.lo;
        for (int k = 0; k < 3; ++k) {
            const float scale = static_cast<float>(bins) / extent[k];
            if (std::isfinite(scale)) scale_[k] = scale;
        }
    }

    int bins() const { return bins_; }
    /// Along a flat axis there is only one bin.
    bool is_flat(int axis) const { return scale_[axis] == 0; }
    int bin(const Eigen::Array4f& centroid, int axis) const { return bins_of(centroid)[axis]; }
    Eigen::Array4i bins_of(const Eigen::Array4f& centroid) const {
        return ((centroid - lo_) * scale_).cast<int>().min(bins_ - 1);
    }

private:
    Eigen::Array4f lo_;
    Eigen::Array4f scale_ = Eigen::Array4f::Zero();
    int bins_;
};

class BinnedSahBuilder {
public:
    BinnedSahBuilder(std::span<const Box3f> boxes, const BinnedSahOptions& options)
        : options_(options), half_scale_(0.5f * unit_scale(boxes)), references_(boxes.size()) {
        for (std::uint32_t i = 0; i < boxes.size(); ++i) references_[i] = {PaddedBox(boxes[i]), i};
        tree_.nodes.resize(2 * boxes.size() - 1);
        tree_.order.resize(boxes.size());
    }

    Tree build() && {
        build_node(0, 0, static_cast<std::uint32_t>(references_.size()), 0);
        close_gaps(tree_.nodes);
        return std::move(tree_);
    }

private:
    void build_node(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
        Node& node = tree_.nodes[index];
        PaddedBox bounds, centroid_bounds;
        for (std::uint32_t i = begin; i < end; ++i) {
            bounds.extend(references_[i].box);
            centroid_bounds.extend(centroid(references_[i]));
        }
        node.box = bounds.box();
        const std::uint32_t count = end - begin;
        if (count == 1) return make_leaf(node, begin, end);

        const Binning binning(centroid_bounds, std::min<int>(options_.bins, count));
        const Split split = depth < kDeepestSahSplit ? best_split(binning, begin, end) : Split{};
        const double area = half_area(bounds);
        if (count <= options_.largest_leaf &&
            options_.primitive_cost * count * area <=
                options_.node_cost * area + options_.primitive_cost * split.cost)
            return make_leaf(node, begin, end);

        const std::uint32_t middle = split.axis >= 0
                                         ? partition(binning, split, begin, end)
                                         : halve(centroid_bounds.box().longest_axis(), begin, end);
        node.first = slot_of_children(middle);
        invoke_both(
            count > kSmallestTask, [&] { build_node(node.left(), begin, middle, depth + 1); },
            [&] { build_node(node.right(), middle, end, depth + 1); });
    }

    void make_leaf(Node& node, std::uint32_t begin, std::uint32_t end) {
        node.first = begin;
        node.count = end - begin;
        for (std::uint32_t i = begin; i < end; ++i) tree_.order[i] = references_[i].primitive;
    }

    Split best_split(const Binning& binning, std::uint32_t begin, std::uint32_t end) const {
        std::array<std::array<Bin, kMostBins>, 3> bins;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Eigen::Array4i bin = binning.bins_of(centroid(references_[i]));
            for (int axis = 0; axis < 3; ++axis) bins[axis][bin[axis]].add({references_[i].box, 1});
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!binning.is_flat(axis)) try_borders(bins[axis], binning.bins(), axis, best);
        }
        return best;
    }

    /// The outermost bins are never empty, so each border leaves something on both sides.
    void try_borders(const std::array<Bin, kMostBins>& bins, int count, int axis,
                     Split& best) const {
        std::array<double, kMostBins> right_cost;
        Bin right;
        for (int i = count - 1; i > 0; --i) {
            right.add(bins[i]);
            right_cost[i] = half_area(right.box) * right.count;
        }
        Bin left;
        for (int i = 1; i < count; ++i) {
            left.add(bins[i - 1]);
            const double cost = half_area(left.box) * left.count + right_cost[i];
            if (cost < best.cost) best = {cost, axis, i};
        }
    }

    std::uint32_t partition(const Binning& binning, const Split& split, std::uint32_t begin,
                            std::uint32_t end) {
        const auto middle =
            std::partition(references_.begin() + begin, references_.begin() + end,
                           [&](const Reference& reference) {
                               return binning.bin(centroid(reference), split.axis) < split.bin;
                           });
        return static_cast<std::uint32_t>(middle - references_.begin());
    }

    std::uint32_t halve(int axis, std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t middle = begin + (end - begin + 1) / 2;
        std::nth_element(references_.begin() + begin, references_.begin() + middle,
                         references_.begin() + end, [&](const Reference& a, const Reference& b) {
                             const float a_place = centroid(a)[axis], b_place = centroid(b)[axis];
                             return a_place != b_place ? a_place < b_place
                                                       : a.primitive < b.primitive;
                         });
        return middle;
    }

    /// In units in which areas don't overflow. Boxes that nothing hits go to the origin.
    Eigen::Array4f centroid(const Reference& reference) const {
        const PaddedBox& box = reference.box;
        if (box.is_empty()) return Eigen::Array4f::Zero();
        return half_scale_ * box.lo + half_scale_ * box.hi;
    }
    double half_area(const PaddedBox& box) const {
        if (box.is_empty()) return 0;
        const Eigen::Array4f e = 2 * half_scale_ * box.hi - 2 * half_scale_ * box.lo;
        return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
    }

    BinnedSahOptions options_;
    float half_scale_;
    std::vector<Reference> references_;
    Tree tree_;
};

}  // namespace

Tree build_binned_sah(std::span<const Box3f> boxes, const BinnedSahOptions& options) {
    if (options.bins < 2 || options.bins > kMostBins || options.largest_leaf < 1)
        throw InvalidInput("build_binned_sah: expected 2 to 32 bins and leaves of at least 1");
    if (boxes.empty()) return {};
    return BinnedSahBuilder(boxes, options).build();
}

}  // namespace boxwood
