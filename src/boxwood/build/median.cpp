// SPDX-License-Identifier: Apache-2.0
// Top-down construction: sort the primitives by centroid along the longest axis of the box that the
// centroids span, give the left half (rounded up) to one child and the rest to the other, and go on
// until one primitive is left. Only the halves matter, not the order within them, so a selection
// does for the sort and the whole takes O(n log n).
// Explained in docs/algorithms/median.md.
#include "boxwood/build/median.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "boxwood/build/slots.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"

namespace boxwood {

namespace {

struct Item {
    Vec3d centroid;
    std::uint32_t primitive;
};

class MedianBuilder {
public:
    MedianBuilder(std::span<const Box3f> boxes, std::vector<Item> items)
        : boxes_(boxes), items_(std::move(items)) {
        tree_.nodes.resize(2 * items_.size() - 1);
        tree_.order.resize(items_.size());
    }

    Tree build() && {
        build_node(0, 0, static_cast<std::uint32_t>(items_.size()));
        return std::move(tree_);
    }

private:
    void build_node(std::uint32_t index, std::uint32_t begin, std::uint32_t end) {
        Node& node = tree_.nodes[index];
        if (end - begin == 1) {
            const std::uint32_t primitive = items_[begin].primitive;
            tree_.order[begin] = primitive;
            node = {boxes_[primitive], begin, 1};
            return;
        }
        const std::uint32_t middle = begin + (end - begin + 1) / 2;
        split_at(middle, begin, end);

        const std::uint32_t left = slot_of_children(middle);
        invoke_both(
            end - begin > kSmallestTask, [&] { build_node(left, begin, middle); },
            [&] { build_node(left + 1, middle, end); });
        node = {merged(tree_.nodes[left].box, tree_.nodes[left + 1].box), left, 0};
    }

    void split_at(std::uint32_t middle, std::uint32_t begin, std::uint32_t end) {
        Box3d centroid_bounds;
        for (std::uint32_t i = begin; i < end; ++i) centroid_bounds.extend(items_[i].centroid);
        const int axis = centroid_bounds.longest_axis();

        // Equal centroids go by index, so that there is one answer.
        const auto is_left = [axis](const Item& a, const Item& b) {
            if (a.centroid[axis] != b.centroid[axis]) return a.centroid[axis] < b.centroid[axis];
            return a.primitive < b.primitive;
        };
        std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                         is_left);
    }

    std::span<const Box3f> boxes_;
    std::vector<Item> items_;
    Tree tree_;
};

}  // namespace

Tree build_median(std::span<const Box3f> boxes, const MedianOptions& options) {
    if (!options.centroids.empty() && options.centroids.size() != boxes.size())
        throw InvalidInput("build_median: expected as many centroids as boxes");
    if (boxes.empty()) return {};

    std::vector<Item> items(boxes.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const Vec3d centroid = options.centroids.empty() ? Vec3d(boxes[i].centroid().cast<double>())
                                                         : options.centroids[i];
        // Boxes that nothing hits have no place to be sorted by.
        items[i] = {centroid.allFinite() ? centroid : Vec3d(Vec3d::Zero()), i};
    }
    return MedianBuilder(boxes, std::move(items)).build();
}

}  // namespace boxwood
