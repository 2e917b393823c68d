// SPDX-License-Identifier: Apache-2.0
// Bottom-up construction: start with a leaf for each primitive and merge the pair of nodes of least
// cost until one node is left. Trying all pairs each time would be cubic. Instead each node
// remembers its cheapest partner among the nodes after it, so that finding the pair and replacing
// it by its union is a scan over the nodes each. A node whose partner was merged away keeps the old
// cost as a lower bound, and looks for a new partner only when that bound is the least of all.
// Sources: Walter et al., "Fast Agglomerative Clustering for Rendering", IEEE Symposium on
// Interactive Ray Tracing, 2008; Muellner, "Modern hierarchical, agglomerative clustering
// algorithms", arXiv:1109.2378, 2011. Explained in docs/algorithms/agglomerative.md.
#include "boxwood/build/agglomerative.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "boxwood/build/merge_scan.h"
#include "boxwood/tree/parents.h"

namespace boxwood {

namespace {

/// The cheapest pair in which a node is the lower one.
struct Partner {
    std::uint32_t node = 0;
    bool is_gone = false;  ///< merged away since: the cost is only a lower bound
};

class AgglomerativeBuilder {
public:
    AgglomerativeBuilder(std::span<const Box3f> boxes, MergeCost cost)
        : boxes_(boxes),
          scan_(boxes, cost),
          size_(static_cast<std::uint32_t>(boxes.size())),
          name_(size_),
          partner_(size_),
          cost_(size_) {
        for (std::uint32_t i = 0; i < size_; ++i) name_[i] = i;
        for (std::uint32_t i = 0; i < size_; ++i) find_partner(i);
    }

    Tree build() && {
        merges_.reserve(boxes_.size());
        while (live() > 1) {
            merge(cheapest_node());
            if (4 * live() < 3 * size_) close_gaps();
        }
        return make_tree();
    }

private:
    std::size_t live() const { return boxes_.size() - merges_.size(); }

    void find_partner(std::uint32_t i) {
        scan_.compute_costs(i, i + 1, size_);
        set_cheapest_partner(i);
    }

    void set_cheapest_partner(std::uint32_t i) {
        std::tie(partner_[i].node, cost_[i]) = scan_.cheapest(i + 1, size_);
        partner_[i].is_gone = false;
    }

    /// The lower node of the pair to merge next.
    std::uint32_t cheapest_node() {
        for (;;) {
            const float least = cost_.head(size_).minCoeff();
            const float* found = std::find(cost_.data(), cost_.data() + size_, least);
            const auto i = static_cast<std::uint32_t>(found - cost_.data());
            if (!partner_[i].is_gone) return i;
            find_partner(i);
        }
    }

    /// Puts the union in the place of node i and leaves its partner's place empty.
    void merge(std::uint32_t i) {
        const std::uint32_t j = partner_[i].node;
        merges_.emplace_back(name_[i], name_[j]);
        name_[i] = static_cast<std::uint32_t>(boxes_.size() + merges_.size() - 1);
        name_[j] = kNobody;
        scan_.merge(i, j);
        cost_[j] = std::numeric_limits<float>::infinity();
        partner_[j] = {};

        scan_.compute_costs(i, 0, size_);
        for (std::uint32_t k = 0; k < i; ++k) offer_partner(k, i);
        for (std::uint32_t k = 0; k < j; ++k) {
            if (partner_[k].node == j) partner_[k].is_gone = true;
        }
        set_cheapest_partner(i);
    }

    /// Node i has just changed: it may be a better partner for node k, or no longer the best.
    void offer_partner(std::uint32_t k, std::uint32_t i) {
        const float cost = scan_.cost(k);
        Partner& partner = partner_[k];
        // On a tie the lower partner counts; where it is gone, a search has to tell which that is.
        if (cost < cost_[k] || (cost == cost_[k] && !partner.is_gone && i <= partner.node)) {
            partner = {i, false};
            cost_[k] = cost;
        } else if (partner.node == i) {
            partner.is_gone = true;
        }
    }

    /// Moves the nodes together, in their order, so that the scans stay short.
    void close_gaps() {
        std::vector<std::uint32_t> new_place(size_, kNobody);
        std::uint32_t end = 0;
        for (std::uint32_t i = 0; i < size_; ++i) {
            if (name_[i] == kNobody) continue;
            scan_.move(i, end);
            name_[end] = name_[i];
            partner_[end] = partner_[i];
            cost_[end] = cost_[i];
            new_place[i] = end++;
        }
        size_ = end;
        for (std::uint32_t i = 0; i < size_; ++i) {
            Partner& partner = partner_[i];
            partner.node = partner.node < new_place.size() ? new_place[partner.node] : kNobody;
            partner.is_gone |= partner.node == kNobody;
        }
    }

    Tree make_tree() const {
        std::vector<Box3f> union_of(merges_.size());
        const auto box = [&](std::uint32_t name) {
            return name < boxes_.size() ? boxes_[name] : union_of[name - boxes_.size()];
        };
        for (std::size_t k = 0; k < merges_.size(); ++k)
            union_of[k] = merged(box(merges_[k].first), box(merges_[k].second));

        Tree tree;
        tree.nodes.resize(1);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> to_do = {{name_[0], 0}};
        while (!to_do.empty()) {
            const auto [name, index] = to_do.back();
            to_do.pop_back();
            if (name < boxes_.size()) {
                tree.nodes[index] = {box(name), static_cast<std::uint32_t>(tree.order.size()), 1};
                tree.order.push_back(name);
            } else {
                const auto left = static_cast<std::uint32_t>(tree.nodes.size());
                tree.nodes.resize(left + 2);
                tree.nodes[index] = {box(name), left, 0};
                to_do.emplace_back(merges_[name - boxes_.size()].second, left + 1);
                to_do.emplace_back(merges_[name - boxes_.size()].first, left);
            }
        }
        add_parents(tree);
        return tree;
    }

    static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

    std::span<const Box3f> boxes_;
    MergeScan scan_;
    std::uint32_t size_;               ///< places in use, some of them empty
    std::vector<std::uint32_t> name_;  ///< of the node in a place: see merges_
    std::vector<Partner> partner_;
    Eigen::ArrayXf cost_;
    /// The nodes that were merged. Node p < n is primitive p, node n + k the result of merge k.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> merges_;
};

}  // namespace

Tree build_agglomerative(std::span<const Box3f> boxes, const AgglomerativeOptions& options) {
    if (boxes.empty()) return {};
    return AgglomerativeBuilder(boxes, options.cost).build();
}

}  // namespace boxwood
