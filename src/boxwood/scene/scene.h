// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/core/batch.h"
#include "boxwood/core/ray.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/hit_lists.h"
#include "boxwood/query/traverse.h"
#include "boxwood/query/wide_tree.h"
#include "boxwood/scene/build_wide_tree.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

/// How a scene finds its hits.
struct SceneOptions {
    BuildPreset preset = BuildPreset::balanced;
    std::optional<BuildOptions> build = {};  ///< a builder of your choice in place of the preset
    bool brute_force = false;                ///< no trees: test every triangle
    /// Keeps the trees as they were built, beside the fast form that queries walk: for queries that
    /// count their steps, and for trees().
    bool keep_trees = false;
};

/// Triangle meshes that can be asked what a ray hits. It refers to the meshes' arrays, which must
/// outlive it and stay as they are. Queries may run from any number of threads at once.
class Scene {
public:
    /// Throws InvalidInput when a face has an index out of range. Costs what the builder costs.
    explicit Scene(std::vector<MeshView> meshes, const SceneOptions& options = {});

    /// The hit with the least t in [ray.t_min, ray.t_max], or nothing. Equal distances go to the
    /// lower (mesh, triangle), so the answer doesn't depend on the options. See closest_hit.h.
    std::optional<Hit> closest_hit(const Ray& ray) const noexcept;
    /// The same, adding up the steps through the trees as they were built, or by brute force.
    /// Precondition: counts_steps().
    std::optional<Hit> closest_hit(const Ray& ray, TraversalCounts& counts) const noexcept;

    /// Whether anything is hit in [ray.t_min, ray.t_max].
    bool any_hit(const Ray& ray) const noexcept;

    /// closest_hit() of each ray, in order and to the last bit, on all cores; Hit{} where there is
    /// none. Takes no memory that grows with the rays. Throws InvalidInput when the sizes differ,
    /// Cancelled when options.cancellation asks for it; what is in hits then is of no use.
    void closest_hits(std::span<const Ray> rays, std::span<Hit> hits,
                      const BatchOptions& options = {}) const;
    /// any_hit() of each ray, likewise.
    void any_hits(std::span<const Ray> rays, std::span<bool> hits,
                  const BatchOptions& options = {}) const;

    /// The places where the ray goes through the meshes, with t in [ray.t_min, ray.t_max], in the
    /// order of t; equal t in that of (mesh, triangle). Edges and vertices count once for each
    /// crossing of each mesh, by the rule of query/all_hits.h.
    std::vector<Hit> all_hits(const Ray& ray) const;
    /// Their number.
    std::size_t count_hits(const Ray& ray) const;
    /// Those that are first, as many as there are places: their number, and Hit{} in the places
    /// left.
    std::size_t first_k_hits(const Ray& ray, std::span<Hit> hits) const noexcept;

    /// The same for each ray, as closest_hits() does it. Lists take, while at work, two and a
    /// quarter times the memory that they need in the end. For first_k_hits() hits has a row of k
    /// places for each ray, one after another.
    HitLists all_hits(std::span<const Ray> rays, const BatchOptions& options = {}) const;
    void count_hits(std::span<const Ray> rays, std::span<std::size_t> counts,
                    const BatchOptions& options = {}) const;
    void first_k_hits(std::span<const Ray> rays, std::size_t k, std::span<Hit> hits,
                      const BatchOptions& options = {}) const;

    std::span<const MeshView> meshes() const { return meshes_; }
    /// Whether queries can count their steps: with options.keep_trees or options.brute_force.
    bool counts_steps() const { return wide_trees_.size() == trees_.size(); }
    /// One a mesh, where they are kept.
    std::span<const Tree> trees() const { return trees_; }
    /// What queries walk; one a mesh, none where it is brute force.
    std::span<const WideTree> wide_trees() const { return wide_trees_; }

private:
    template <class ClosestHitOnMesh>
    std::optional<Hit> closest_of_meshes(const Ray& ray, const ClosestHitOnMesh& on_mesh,
                                         TraversalCounts* counts) const noexcept;
    void add_crossings(const Ray& ray, std::vector<Hit>& hits) const;

    std::vector<MeshView> meshes_;
    std::vector<Tree> trees_;
    std::vector<WideTree> wide_trees_;
    Tree top_;  ///< over the meshes
};

}  // namespace boxwood
