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
#include "boxwood/query/traverse.h"

namespace boxwood {

namespace {

/// Calls visit(hit) for each crossing, some twice. It returns the t beyond which nothing is of
/// interest; minus infinity ends the walk.
template <class Surface, class Visit>
void visit_crossings(const Surface& surface, const WideTree& tree, const Ray& ray,
                     std::uint32_t instance, const Visit& visit) noexcept {
    if (tree.is_empty() || !is_traceable(ray)) return;
    const NearRay near = near_ray(surface, tree, ray);
    const MeshRay mesh_ray(surface, ray);
    double t_max = ray.t_max;
    float farthest = near.ray().t_max;
    auto look_at = [&](const auto& candidate) {
        if (auto hit = mesh_ray.crossing(candidate, t_max)) {
            hit->instance = instance;
            const double limit = visit(*hit);
            if (limit < t_max) {
                t_max = limit;
                farthest = limit == kEndOfWalk ? -std::numeric_limits<float>::infinity()
                                               : near.farthest(limit);
            }
        }
        return farthest;
    };
    if (near.can_leave_out()) {
        visit_candidates(tree, near, look_at);
    } else {
        for (std::uint32_t i = 0; i < face_count(surface); ++i) look_at(i);
    }
}

template <class Surface, class Visit>
void visit_crossings_brute_force(const Surface& surface, const Ray& ray, std::uint32_t instance,
                                 const Visit& visit) {
    if (!is_traceable(ray)) return;
    const MeshRay mesh_ray(surface, ray);
    for (std::uint32_t i = 0; i < face_count(surface); ++i) {
        if (auto hit = mesh_ray.crossing(i, ray.t_max)) {
            hit->instance = instance;
            visit(*hit);
        }
    }
}

}  // namespace

template <class Surface>
void add_crossings(const Surface& surface, const WideTree& tree, const Ray& ray,
                   std::uint32_t instance, std::vector<Hit>& hits) {
    // Kernels let no exception through.
    std::exception_ptr out_of_memory;
    visit_crossings(surface, tree, ray, instance, [&](const Hit& hit) {
        try {
            hits.push_back(hit);
            return std::numeric_limits<double>::infinity();
        } catch (...) {
            out_of_memory = std::current_exception();
            return kEndOfWalk;
        }
    });
    if (out_of_memory) std::rethrow_exception(out_of_memory);
}

template <class Surface>
void add_crossings_brute_force(const Surface& surface, const Ray& ray, std::uint32_t instance,
                               std::vector<Hit>& hits) {
    visit_crossings_brute_force(surface, ray, instance,
                                [&](const Hit& hit) { hits.push_back(hit); });
}

template <class Surface>
void offer_crossings(const Surface& surface, const WideTree& tree, const Ray& ray,
                     std::uint32_t instance, FirstCrossings& first) noexcept {
    visit_crossings(surface, tree, ray, instance, [&](const Hit& hit) {
        first.offer(hit);
        return first.t_max();
    });
}

template <class Surface>
void offer_crossings_brute_force(const Surface& surface, const Ray& ray, std::uint32_t instance,
                                 FirstCrossings& first) noexcept {
    visit_crossings_brute_force(surface, ray, instance, [&](const Hit& hit) { first.offer(hit); });
}

template void add_crossings(const MeshView&, const WideTree&, const Ray&, std::uint32_t,
                            std::vector<Hit>&);
template void add_crossings(const PlacedMesh&, const WideTree&, const Ray&, std::uint32_t,
                            std::vector<Hit>&);
template void add_crossings_brute_force(const MeshView&, const Ray&, std::uint32_t,
                                        std::vector<Hit>&);
template void add_crossings_brute_force(const PlacedMesh&, const Ray&, std::uint32_t,
                                        std::vector<Hit>&);
template void offer_crossings(const MeshView&, const WideTree&, const Ray&, std::uint32_t,
                              FirstCrossings&) noexcept;
template void offer_crossings(const PlacedMesh&, const WideTree&, const Ray&, std::uint32_t,
                              FirstCrossings&) noexcept;
template void offer_crossings_brute_force(const MeshView&, const Ray&, std::uint32_t,
                                          FirstCrossings&) noexcept;
template void offer_crossings_brute_force(const PlacedMesh&, const Ray&, std::uint32_t,
                                          FirstCrossings&) noexcept;

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
