// SPDX-License-Identifier: Apache-2.0
// The queries of a scene for more than one hit: those of its instances, put
// together.
#include <algorithm>
#include <exception>

#include "boxwood/query/crossing_batches.h"
#include "boxwood/query/crossings.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/scene/ask_instance.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

void Scene::add_crossings(const Ray& ray, std::vector<Hit>& hits) const {
    // The walk lets no exception through.
    std::exception_ptr out_of_memory;
    visit_instances(ray, [&](std::uint32_t instance, const Ray& asked) {
        try {
            ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
                if (tree)
                    boxwood::add_crossings(surface, *tree, asked, instance, hits);
                else
                    add_crossings_brute_force(surface, asked, instance, hits);
            });
            return asked.t_max;
        } catch (...) {
            out_of_memory = std::current_exception();
            return kEndOfWalk;
        }
    });
    if (out_of_memory) std::rethrow_exception(out_of_memory);
}

std::vector<Hit> Scene::all_hits(const Ray& ray) const {
    std::vector<Hit> hits;
    add_crossings(ray, hits);
    sort_crossings(hits);
    return hits;
}

std::size_t Scene::count_hits(const Ray& ray) const { return all_hits(ray).size(); }

std::size_t Scene::first_k_hits(const Ray& ray, std::span<Hit> hits) const noexcept {
    FirstCrossings first(hits);
    if (hits.empty()) return 0;
    visit_instances(ray, [&](std::uint32_t instance, const Ray& asked) {
        ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
            if (tree)
                offer_crossings(surface, *tree, asked, instance, first);
            else
                offer_crossings_brute_force(surface, asked, instance, first);
        });
        return std::min(asked.t_max, first.t_max());
    });
    return first.count();
}

HitLists Scene::all_hits(std::span<const Ray> rays, const BatchOptions& options) const {
    return crossings_of_all(rays.size(), options, [&](std::size_t i, std::vector<Hit>& hits) {
        add_crossings(rays[i], hits);
    });
}

void Scene::count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                       const BatchOptions& options) const {
    check_count_places(rays.size(), counts.size());
    count_crossings_of_all(counts, options, [&](std::size_t i, std::vector<Hit>& hits) {
        add_crossings(rays[i], hits);
    });
}

void Scene::first_k_hits(std::span<const Ray> rays, std::size_t k, std::span<Hit> hits,
                         const BatchOptions& options) const {
    check_hit_rows(rays.size(), k, hits.size());
    first_crossings_of_all(rays.size(), k, hits, options,
                           [&](std::size_t i, std::span<Hit> row) { first_k_hits(rays[i], row); });
}

}  // namespace boxwood
