// SPDX-License-Identifier: Apache-2.0
// What the queries for more than one hit keep while they walk trees, of one mesh or of many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boxwood/core/ray.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/query/wide_tree.h"

namespace boxwood {

/// The order of hits along a ray: see core/ray.h.
struct ByDistance {
    bool operator()(const Hit& a, const Hit& b) const { return is_closer(a, b); }
};

// For a Surface that is a MeshView or a PlacedMesh. Hits get the instance as their Hit::instance;
// ray.skip is a triangle of it.

/// Adds the crossings of a surface, in no order, some twice where a builder splits triangles.
template <class Surface>
void add_crossings(const Surface& surface, const WideTree& tree, const Ray& ray,
                   std::uint32_t instance, std::vector<Hit>& hits);
/// The same by testing every triangle, each once.
template <class Surface>
void add_crossings_brute_force(const Surface& surface, const Ray& ray, std::uint32_t instance,
                               std::vector<Hit>& hits);

/// Puts the hits from `begin` on in order and leaves each of them once.
inline void sort_crossings(std::vector<Hit>& hits, std::size_t begin = 0) {
    const auto first = hits.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, hits.end(), ByDistance());
    const auto is_same = [](const Hit& a, const Hit& b) {
        return a.instance == b.instance && a.triangle == b.triangle;
    };
    // The same triangle has the same t, so it stands beside itself.
    hits.erase(std::unique(first, hits.end(), is_same), hits.end());
}

/// The first crossings of those that are offered, in order, each once; in somebody else's places.
class FirstCrossings {
public:
    explicit FirstCrossings(std::span<Hit> places) : places_(places) {
        std::fill(places_.begin(), places_.end(), Hit{});
    }

    /// O(places), as it moves those behind.
    void offer(const Hit& hit) {
        const auto end = places_.begin() + static_cast<std::ptrdiff_t>(count_);
        const auto place = std::lower_bound(places_.begin(), end, hit, ByDistance());
        if (place == places_.end() || (place != end && !is_closer(hit, *place))) return;
        if (count_ < places_.size()) ++count_;
        const auto last = places_.begin() + static_cast<std::ptrdiff_t>(count_) - 1;
        std::move_backward(place, last, last + 1);
        *place = hit;
    }

    std::size_t count() const { return count_; }
    /// Beyond it nothing is of interest any more. Precondition: there are places.
    double t_max() const {
        return count_ < places_.size() ? std::numeric_limits<double>::infinity() : places_.back().t;
    }

private:
    std::span<Hit> places_;
    std::size_t count_ = 0;
};

/// Offers the crossings of a surface, as add_crossings() does.
template <class Surface>
void offer_crossings(const Surface& surface, const WideTree& tree, const Ray& ray,
                     std::uint32_t instance, FirstCrossings& first) noexcept;
template <class Surface>
void offer_crossings_brute_force(const Surface& surface, const Ray& ray, std::uint32_t instance,
                                 FirstCrossings& first) noexcept;

}  // namespace boxwood
