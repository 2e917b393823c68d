// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/scene.h"

#include <algorithm>
#include <utility>

#include "boxwood/query/any_hit.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/certified_hits.h"
#include "boxwood/query/closest_hit.h"
#include "boxwood/query/hit_places.h"
#include "boxwood/scene/ray_in_mesh.h"

namespace boxwood {

namespace {

/// Rays between two looks at whether to go on: few, as by brute force each may take long.
constexpr std::size_t kPiece = 256;

BuiltTree build(MeshView mesh, const SceneOptions& options) {
    if (!options.build) return build_preset(mesh, {.preset = options.preset});
    Tree tree = build_tree(mesh, *options.build);
    WideTree wide(mesh, tree);
    return {std::move(tree), std::move(wide)};
}

}  // namespace

Scene::Scene(std::vector<MeshView> meshes, const SceneOptions& options)
    : meshes_(std::move(meshes)) {
    for (const MeshView& mesh : meshes_) check_indices(mesh);
    if (options.brute_force) return;

    std::vector<Box3f> boxes;
    for (const MeshView& mesh : meshes_) {
        BuiltTree built = build(mesh, options);
        boxes.push_back(built.wide.bounds());
        wide_trees_.push_back(std::move(built.wide));
        if (options.keep_trees) trees_.push_back(std::move(built.tree));
    }
    // A single mesh needs no second tree to be found by.
    if (meshes_.size() > 1) top_ = build_tree(boxes);
}

template <class ClosestHitOnMesh>
std::optional<Hit> Scene::closest_of_meshes(const Ray& ray, const ClosestHitOnMesh& on_mesh,
                                            TraversalCounts* counts) const noexcept {
    if (!is_traceable(ray)) return std::nullopt;
    std::optional<Hit> closest;
    const auto visit = [&](std::uint32_t mesh, double t_max) {
        Ray shortened = ray_in_mesh(ray, mesh);
        shortened.t_max = t_max;
        auto hit = on_mesh(mesh, shortened);
        if (!hit) return t_max;
        hit->mesh = mesh;
        if (!closest || is_closer(*hit, *closest)) closest = hit;
        return closest->t;
    };

    if (!top_.is_empty()) {
        traverse(top_, ray, visit, counts);
    } else {
        double t_max = ray.t_max;
        for (std::uint32_t mesh = 0; mesh < meshes_.size(); ++mesh) t_max = visit(mesh, t_max);
    }
    return closest;
}

std::optional<Hit> Scene::closest_hit(const Ray& ray) const noexcept {
    const auto on_mesh = [&](std::uint32_t mesh, const Ray& shortened) {
        return wide_trees_.empty()
                   ? closest_hit_brute_force(meshes_[mesh], shortened)
                   : boxwood::closest_hit(meshes_[mesh], wide_trees_[mesh], shortened);
    };
    return closest_of_meshes(ray, on_mesh, nullptr);
}

std::optional<Hit> Scene::closest_hit(const Ray& ray, TraversalCounts& counts) const noexcept {
    const auto on_mesh = [&](std::uint32_t mesh, const Ray& shortened) {
        return trees_.empty()
                   ? closest_hit_brute_force(meshes_[mesh], shortened, &counts)
                   : boxwood::closest_hit(meshes_[mesh], trees_[mesh], shortened, &counts);
    };
    return closest_of_meshes(ray, on_mesh, &counts);
}

bool Scene::any_hit(const Ray& ray) const noexcept {
    if (!is_traceable(ray)) return false;
    bool found = false;
    const auto visit = [&](std::uint32_t mesh, double t_max) {
        const Ray mesh_ray = ray_in_mesh(ray, mesh);
        found = found || (wide_trees_.empty()
                              ? any_hit_brute_force(meshes_[mesh], mesh_ray)
                              : boxwood::any_hit(meshes_[mesh], wide_trees_[mesh], mesh_ray));
        return found ? kEndOfWalk : t_max;
    };

    if (!top_.is_empty()) {
        traverse(top_, ray, visit);
    } else {
        for (std::uint32_t mesh = 0; mesh < meshes_.size() && !found; ++mesh)
            visit(mesh, ray.t_max);
    }
    return found;
}

void Scene::closest_hits(std::span<const Ray> rays, std::span<Hit> hits,
                         const BatchOptions& options) const {
    check_hit_places(rays.size(), hits.size());
    for_each_piece(rays.size(), kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) hits[i] = closest_hit(rays[i]).value_or(Hit{});
    });
}

void Scene::any_hits(std::span<const Ray> rays, std::span<bool> hits,
                     const BatchOptions& options) const {
    check_hit_places(rays.size(), hits.size());
    for_each_piece(rays.size(), kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) hits[i] = any_hit(rays[i]);
    });
}

}  // namespace boxwood
