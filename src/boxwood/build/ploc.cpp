// SPDX-License-Identifier: Apache-2.0
// Bottom-up construction without the search among all pairs: in the order of a curve through space
// a node's best partner is rarely far away. So each node looks at its neighbours within a radius,
// all nodes that are each other's best merge at once, the gaps are closed, and so on. O(n) a round,
// and as almost all rounds remove an eighth of the nodes or more, O(log n) rounds.
// Sources: Meister and Bittner, "Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy
// Construction", IEEE TVCG 24(3), 2018; Benthin et al., "PLOC++", Proceedings of the ACM on
// Computer Graphics and Interactive Techniques 5(3), 2022. Explained in docs/algorithms/ploc.md.
#include "boxwood/build/ploc.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "boxwood/build/clusters.h"
#include "boxwood/build/merge_tree.h"
#include "boxwood/build/morton_order.h"
#include "boxwood/build/unit_scale.h"
#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/tree/parents.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;
/// Rounds in which less than an eighth of the nodes go. Meshes have a few, with few nodes left.
constexpr int kMostSlowRounds = 64;
constexpr std::size_t kPrefetch = 32;

class PlocBuilder {
public:
    PlocBuilder(std::span<const Box3f> boxes, const PlocOptions& options)
        : options_(options),
          boxes_(boxes),
          order_(boxes.size()),
          merges_(boxes.size() - 1),
          cost_(boxes.size() - 1),
          clusters_(boxes.size()),
          next_(boxes.size()),
          best_(boxes.size()),
          partner_(boxes.size()) {}

    Tree build() && {
        sort_primitives();
        load_clusters();
        while (clusters_.size > 1) {
            find_partners();
            merge_pairs();
            std::swap(clusters_, next_);
        }
        return make_merge_tree(boxes_, order_, merges_);
    }

private:
    void sort_primitives() {
        const std::unique_ptr<MortonKey[]> memory(new MortonKey[2 * boxes_.size()]);
        const std::span keys(memory.get(), boxes_.size());
        number_primitives(keys);
        sort_along_curve(boxes_, keys, {memory.get() + boxes_.size(), boxes_.size()});
        parallel_for(keys.size(), kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) order_[i] = primitive_of(keys[i]);
        });
    }

    void load_clusters() {
        const float scale = unit_scale(boxes_);
        parallel_for(boxes_.size(), kPiece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                // Boxes lie anywhere in memory: ask for them early.
                __builtin_prefetch(&boxes_[order_[std::min(i + kPrefetch, order_.size() - 1)]]);
                const Box3f& box = boxes_[order_[i]];
                for (int k = 0; k < 3; ++k) {
                    // Boxes that nothing hits have no place; any will do. No area may be infinite.
                    const bool is_empty = box.is_empty();
                    clusters_.lo[k][i] = is_empty ? 0 : std::clamp(scale * box.lo[k], -4.0f, 4.0f);
                    clusters_.hi[k][i] = is_empty ? 0 : std::clamp(scale * box.hi[k], -4.0f, 4.0f);
                }
                clusters_.name[i] = static_cast<std::uint32_t>(i);
            }
        });
        clusters_.set_size(boxes_.size());
    }

    /// Each pair is looked at once, from its lower node. The first nodes of a piece have pairs with
    /// nodes before it, which are looked at again.
    void find_partners() {
        parallel_for(clusters_.size, kPiece, [&](std::size_t begin, std::size_t end) {
            const int radius = options_.radius;
            const std::size_t first = begin - std::min<std::size_t>(begin, radius);
            std::vector<PairCost> best(end - first + radius, std::numeric_limits<PairCost>::max());
            std::array<PairCost, kMostRadius> costs;
            for (std::size_t i = first; i < end; ++i) {
                compute_costs(clusters_, i, radius, costs.data());
                PairCost* best_of = &best[i - first];
                PairCost least = *best_of;
                for (int d = 1; d <= radius; ++d) {
                    least = std::min(least, costs[d - 1]);
                    best_of[d] = std::min(best_of[d], costs[d - 1]);
                }
                *best_of = least;
            }
            std::copy(best.begin() + (begin - first), best.begin() + (end - first),
                      best_.begin() + begin);
        });
    }

    void merge_pairs() {
        Counts before = count_pairs([&](std::size_t i) {
            const std::int32_t offset = offset_of_partner(i, best_[i]);
            return best_[i + offset] == best_[i] ? offset : 0;
        });
        const bool is_slow = before.back().merges < clusters_.size / 8;
        if (is_slow && ++slow_rounds_ > kMostSlowRounds) {
            // Costs that fall along the curve may leave one pair a round. Then neighbours merge.
            before = count_pairs([&](std::size_t i) {
                return i % 2 == 1 ? -1 : i + 1 < clusters_.size ? 1 : 0;
            });
        }
        for_each_piece([&](std::size_t p, std::size_t begin, std::size_t end) {
            auto [to, merge] = before[p];
            merge += merged_;
            for (std::size_t i = begin; i < end; ++i) {
                if (partner_[i] == 0) next_.copy(to++, clusters_, i);
                if (partner_[i] > 0) this->merge(i, i + partner_[i], merge++, to++);
            }
        });
        merged_ += before.back().merges;
        next_.set_size(before.back().clusters);
    }

    /// What the pieces before a piece leave to the next round.
    struct Count {
        std::uint32_t clusters = 0, merges = 0;
    };
    using Counts = std::vector<Count>;

    /// Notes partners and tells what each piece has before it; the last Count is that of all.
    template <class OffsetOfPartner>
    Counts count_pairs(const OffsetOfPartner& offset_of) {
        Counts before(1 + (clusters_.size + kPiece - 1) / kPiece);
        for_each_piece([&](std::size_t p, std::size_t begin, std::size_t end) {
            Count count;
            for (std::size_t i = begin; i < end; ++i) {
                partner_[i] = offset_of(i);
                count.clusters += partner_[i] >= 0;
                count.merges += partner_[i] > 0;
            }
            before[p + 1] = count;
        });
        for (std::size_t p = 1; p < before.size(); ++p) {
            before[p].clusters += before[p - 1].clusters;
            before[p].merges += before[p - 1].merges;
        }
        return before;
    }

    template <class Body>
    void for_each_piece(const Body& body) const {
        parallel_for((clusters_.size + kPiece - 1) / kPiece, 1,
                     [&](std::size_t first, std::size_t last) {
                         for (std::size_t p = first; p < last; ++p)
                             body(p, p * kPiece, std::min((p + 1) * kPiece, clusters_.size));
                     });
    }

    /// Makes a merge of nodes i and j, and the node to of the next round.
    void merge(std::size_t i, std::size_t j, std::uint32_t merge, std::size_t to) {
        next_.set_union(to, clusters_, i, j);
        next_.name[to] = static_cast<std::uint32_t>(boxes_.size()) + merge;
        const Part left = part(i), right = part(j);
        const float area = next_.area(to);
        Merge& result = merges_[merge];
        result = {clusters_.name[i], clusters_.name[j], left.count + right.count,
                  left.nodes + right.nodes + 1};
        cost_[merge] = static_cast<float>(options_.node_cost) * area + left.cost + right.cost;
        const float cost_as_leaf =
            static_cast<float>(options_.primitive_cost) * static_cast<float>(result.count) * area;
        if (result.count <= options_.largest_leaf && cost_as_leaf <= cost_[merge]) {
            result.nodes = 1;
            cost_[merge] = cost_as_leaf;
        }
    }

    struct Part {
        std::uint32_t count, nodes;
        float cost;  ///< of a random line that meets the root's box, times that box's area
    };
    Part part(std::size_t i) const {
        const std::uint32_t name = clusters_.name[i];
        if (name < boxes_.size())
            return {1, 1, static_cast<float>(options_.primitive_cost) * clusters_.area(i)};
        const std::size_t merge = name - boxes_.size();
        return {merges_[merge].count, merges_[merge].nodes, cost_[merge]};
    }

    PlocOptions options_;
    std::span<const Box3f> boxes_;
    std::vector<std::uint32_t> order_;  ///< of primitives along the curve
    std::vector<Merge> merges_;
    std::vector<float> cost_;  ///< of what a merge made
    std::uint32_t merged_ = 0;
    int slow_rounds_ = 0;
    Clusters clusters_, next_;
    std::vector<PairCost> best_;         ///< of the pairs of a node
    std::vector<std::int32_t> partner_;  ///< as an offset; 0 says that it waits
};

}  // namespace

Tree build_ploc(std::span<const Box3f> boxes, const PlocOptions& options) {
    if (options.radius < 1 || options.radius > kMostRadius || options.largest_leaf < 1)
        throw InvalidInput("build_ploc: expected a radius of 1 to 32 and leaves of at least 1");
    if (boxes.empty()) return {};
    Tree tree = PlocBuilder(boxes, options).build();
    add_parents(tree);
    return tree;
}

}  // namespace boxwood
