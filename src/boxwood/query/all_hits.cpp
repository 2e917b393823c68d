// SPDX-License-Identifier: Apache-2.0
// Where does a ray go through the surface? The walk of certified_hits.cpp, that goes on after a
// hit; a triangle counts when the ray, moved aside by less than any number, goes through it.
// Explained in docs/algorithms/all_hits.md.
#include "boxwood/query/all_hits.h"

#include <exception>
#include <limits>

#include "boxwood/query/crossing_batches.h"
#include "boxwood/query/crossings.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/query/mesh_ray.h"
#include "boxwood/query/near_ray.h"

namespace boxwood {

namespace {

/// Calls visit(hit) for each crossing, some twice. It returns the t beyond which nothing is of
/// interest; minus infinity ends the walk.
template <class Visit>
void visit_crossings(MeshView mesh, const WideTree& tree, const Ray& ray, std::uint32_t index,
                     const Visit& visit) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return;
    const NearRay near(tree, ray);
    const MeshRay mesh_ray(mesh, ray);
    double t_max = ray.t_max;
    float farthest = near.ray().t_max;
    auto look_at = [&](std::uint32_t triangle) {
        if (auto hit = mesh_ray.crossing(triangle, t_max)) {
            hit->mesh = index;
            const double limit = visit(*hit);
            if (limit < t_max) {
                t_max = limit;
                farthest = near.farthest(limit);
            }
        }
        return farthest;
    };
    if (near.can_leave_out()) {
        visit_candidates(tree, near, look_at);
    } else {
        for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) look_at(i);
    }
}

template <class Visit>
void visit_crossings_brute_force(MeshView mesh, const Ray& ray, std::uint32_t index,
                                 const Visit& visit) {
    if (!is_traceable(ray)) return;
    const MeshRay mesh_ray(mesh, ray);
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        if (auto hit = mesh_ray.crossing(i, ray.t_max)) {
            hit->mesh = index;
            visit(*hit);
        }
    }
}

}  // namespace

void add_crossings(MeshView mesh, const WideTree& tree, const Ray& ray, std::uint32_t index,
                   std::vector<Hit>& hits) {
    // Kernels let no exception through.
    std::exception_ptr out_of_memory;
    visit_crossings(mesh, tree, ray, index, [&](const Hit& hit) {
        try {
            hits.push_back(hit);
            return std::numeric_limits<double>::infinity();
        } catch (...) {
            out_of_memory = std::current_exception();
            return -std::numeric_limits<double>::infinity();
        }
    });
    if (out_of_memory) std::rethrow_exception(out_of_memory);
}

void add_crossings_brute_force(MeshView mesh, const Ray& ray, std::uint32_t index,
                               std::vector<Hit>& hits) {
    visit_crossings_brute_force(mesh, ray, index, [&](const Hit& hit) { hits.push_back(hit); });
}

void offer_crossings(MeshView mesh, const WideTree& tree, const Ray& ray, std::uint32_t index,
                     FirstCrossings& first) noexcept {
    visit_crossings(mesh, tree, ray, index, [&](const Hit& hit) {
        first.offer(hit);
        return first.t_max();
    });
}

void offer_crossings_brute_force(MeshView mesh, const Ray& ray, std::uint32_t index,
                                 FirstCrossings& first) noexcept {
    visit_crossings_brute_force(mesh, ray, index, [&](const Hit& hit) { first.offer(hit); });
}

std::vector<Hit> all_hits(MeshView mesh, const WideTree& tree, const Ray& ray) {
    std::vector<Hit> hits;
    add_crossings(mesh, tree, ray, 0, hits);
    sort_crossings(hits);
    return hits;
}

std::size_t count_hits(MeshView mesh, const WideTree& tree, const Ray& ray) {
    return all_hits(mesh, tree, ray).size();
}

std::size_t first_k_hits(MeshView mesh, const WideTree& tree, const Ray& ray,
                         std::span<Hit> hits) noexcept {
    if (hits.empty()) return 0;
    FirstCrossings first(hits);
    offer_crossings(mesh, tree, ray, 0, first);
    return first.count();
}

HitLists all_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                  const BatchOptions& options) {
    return crossings_of_all(rays.size(), options, [&](std::size_t i, std::vector<Hit>& hits) {
        add_crossings(mesh, tree, rays[i], 0, hits);
    });
}

void count_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays,
                std::span<std::size_t> counts, const BatchOptions& options) {
    check_count_places(rays.size(), counts.size());
    count_crossings_of_all(counts, options, [&](std::size_t i, std::vector<Hit>& hits) {
        add_crossings(mesh, tree, rays[i], 0, hits);
    });
}

void first_k_hits(MeshView mesh, const WideTree& tree, std::span<const Ray> rays, std::size_t k,
                  std::span<Hit> hits, const BatchOptions& options) {
    check_hit_rows(rays.size(), k, hits.size());
    first_crossings_of_all(rays.size(), k, hits, options, [&](std::size_t i, std::span<Hit> row) {
        first_k_hits(mesh, tree, rays[i], row);
    });
}

}  // namespace boxwood
