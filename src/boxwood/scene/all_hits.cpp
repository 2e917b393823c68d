// SPDX-License-Identifier: Apache-2.0
// The queries of a scene for more than one hit: those of its meshes, put together.
#include <algorithm>
#include <exception>

#include "boxwood/query/crossing_batches.h"
#include "boxwood/query/crossings.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/scene/ray_in_mesh.h"
#include "boxwood/scene/scene.h"

namespace boxwood {

void Scene::add_crossings(const Ray& ray, std::vector<Hit>& hits) const {
    if (!is_traceable(ray)) return;
    const auto add = [&](std::uint32_t mesh) {
        if (wide_trees_.empty())
            add_crossings_brute_force(meshes_[mesh], ray_in_mesh(ray, mesh), mesh, hits);
        else
            boxwood::add_crossings(meshes_[mesh], wide_trees_[mesh], ray_in_mesh(ray, mesh), mesh,
                                   hits);
    };
    if (top_.is_empty()) {
        for (std::uint32_t mesh = 0; mesh < meshes_.size(); ++mesh) add(mesh);
        return;
    }
    // The walk lets no exception through.
    std::exception_ptr out_of_memory;
    traverse(top_, ray, [&](std::uint32_t mesh, double t_max) {
        try {
            add(mesh);
            return t_max;
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
    if (hits.empty() || !is_traceable(ray)) return 0;
    const auto visit = [&](std::uint32_t mesh, double t_max) {
        Ray shortened = ray_in_mesh(ray, mesh);
        shortened.t_max = t_max;
        if (wide_trees_.empty())
            offer_crossings_brute_force(meshes_[mesh], shortened, mesh, first);
        else
            offer_crossings(meshes_[mesh], wide_trees_[mesh], shortened, mesh, first);
        return std::min(t_max, first.t_max());
    };
    if (!top_.is_empty()) {
        traverse(top_, ray, visit);
    } else {
        double t_max = ray.t_max;
        for (std::uint32_t mesh = 0; mesh < meshes_.size(); ++mesh) t_max = visit(mesh, t_max);
    }
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
