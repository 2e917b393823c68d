// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boxwood/build/build.h"
#include "boxwood/core/batch.h"
#include "boxwood/core/ray.h"
#include "boxwood/mesh/placed_mesh.h"
#include "boxwood/mesh/triangle_mesh.h"
#include "boxwood/query/closest_point.h"
#include "boxwood/query/hit_lists.h"
#include "boxwood/query/overlaps.h"
#include "boxwood/query/ray_columns.h"
#include "boxwood/query/rayf.h"
#include "boxwood/query/refit.h"
#include "boxwood/query/traverse.h"
#include "boxwood/query/wide_tree.h"
#include "boxwood/scene/build_report.h"
#include "boxwood/scene/build_wide_tree.h"
#include "boxwood/scene/instance.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

struct OpenSceneOptions;

/// How a scene finds its hits.
struct SceneOptions {
    BuildPreset preset = BuildPreset::balanced;
    std::optional<BuildOptions> build = {};  ///< a builder of your choice in place of the preset
    bool brute_force = false;                ///< no trees: test every triangle
    /// Keeps the trees as they were built, beside the fast form that queries walk: for queries that
    /// count their steps, and for trees().
    bool keep_trees = false;
};

/// Triangle meshes, and instances of them, that can be asked what a ray hits. It refers to the
/// meshes' arrays, which must outlive it and stay as they are, but for refit(). Queries may run
/// from any number of threads at once.
class Scene {
public:
    /// An instance of each mesh, where it is. Throws InvalidInput when a face has an index out of
    /// range. Costs what the builder costs.
    explicit Scene(const std::vector<SceneMesh>& meshes, const SceneOptions& options = {});
    /// The instances alone: a mesh without any is not seen. Throws InvalidInput also when one names
    /// no mesh, or its transform isn't finite or has no inverse.
    Scene(std::vector<SceneMesh> meshes, std::vector<Instance> instances,
          const SceneOptions& options);

    Scene(Scene&&) = default;
    Scene& operator=(Scene&&) = default;

    /// What was found wrong with the meshes when they were built or last refitted.
    const BuildReport& report() const { return report_; }

    /// The hit with the least t in [ray.t_min, ray.t_max], or nothing. Equal distances go to the
    /// lower (instance, triangle), so the answer doesn't depend on the options. See closest_hit.h.
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
    /// How many rays these take up at a time, and whether closest_hits() is faster for those of a
    /// camera in tiles. Without a tree each ray takes long, so they are few.
    std::size_t rays_at_a_time() const;
    bool likes_tiles() const { return only_tree() != nullptr; }

    /// Hits in float for rays in float. Where the scene is one instance at the identity, without
    /// culling, the answers are those of query/wide_hits.h: the mesh's vertices are rounded to
    /// float and all arithmetic is in float. Else, and by brute force, they are those in double,
    /// rounded. Either way they are watertight and the same bits everywhere.
    void closest_hits(std::span<const Rayf> rays, std::span<Hitf> hits,
                      const BatchOptions& options = {}) const;
    void any_hits(std::span<const Rayf> rays, std::span<bool> hits,
                  const BatchOptions& options = {}) const;
    /// The same where the parts of rays and hits stand in arrays of their own, but for what
    /// HitColumns says.
    void closest_hits(const RayColumns& rays, const HitColumns& hits,
                      const BatchOptions& options = {}) const;
    void any_hits(const RayColumns& rays, std::span<bool> hits,
                  const BatchOptions& options = {}) const;

    /// The places where the ray goes through the instances, with t in [ray.t_min, ray.t_max], in
    /// the order of t; equal t in that of (instance, triangle). Edges and vertices count once for
    /// each crossing of each instance, by the rule of query/all_hits.h.
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

    /// The place nearest to the point on all instances, if there is one within max_radius, that
    /// included; equal distances go to the lowest (instance, triangle). Distances are those in the
    /// world. See closest_point.h.
    std::optional<ClosestPoint> closest_point(
        const Vec3d& point,
        double max_radius = std::numeric_limits<double>::infinity()) const noexcept;
    /// The same for each point, in order, on all cores, with a few megabytes of memory; one that
    /// finds nothing gets a ClosestPoint{}. Throws InvalidInput when the sizes differ, Cancelled.
    void closest_points(std::span<const Vec3d> points, std::span<ClosestPoint> results,
                        double max_radius = std::numeric_limits<double>::infinity(),
                        const BatchOptions& options = {}) const;

    /// closest_point(), given one of another point, found or not: the nearer that point is, the
    /// sooner. It doesn't show in the answer. Precondition: the scene is as it was then.
    ClosestPoint closest_near(const Vec3d& point, double max_radius,
                              const ClosestPoint& other) const noexcept;

    /// The triangles that touch the box or the sphere, in order, as they stand in the world;
    /// whether any touches the triangle. See overlaps.h.
    std::vector<TriangleId> box_overlap(const Box3d& box) const;
    std::vector<TriangleId> sphere_overlap(const Sphere3d& sphere) const;
    bool triangle_overlap(const TriangleCorners& triangle) const noexcept;
    /// The same for each, on all cores. Throw InvalidInput when the sizes differ, and Cancelled.
    TriangleLists<TriangleId> box_overlaps(std::span<const Box3d> boxes,
                                           const BatchOptions& options = {}) const;
    TriangleLists<TriangleId> sphere_overlaps(std::span<const Sphere3d> spheres,
                                              const BatchOptions& options = {}) const;
    void triangle_overlaps(std::span<const TriangleCorners> triangles, std::span<bool> results,
                           const BatchOptions& options = {}) const;

    /// Of a triangle as it stands in the world, of unit length, from its front; zero for one of
    /// zero area. Precondition: the scene has it.
    Vec3d geometric_normal(TriangleId id) const;
    /// The same with twice the triangle's area as its length.
    Vec3d area_normal(TriangleId id) const;
    Vec3d geometric_normal(const Hit& hit) const {
        return geometric_normal(TriangleId{hit.instance, hit.triangle});
    }

    /// Fits the trees to vertices that have moved, in the arrays that the scene refers to; faces
    /// are the same. All answers are then those of a new scene, and report() tells of it. How good
    /// the trees are yet, one figure a tree: see refit.h. Throws the InvalidInput that it says, and
    /// then leaves the scene as it was; after another exception, for want of memory or of room in a
    /// compact tree, it can only be destroyed. No query may run meanwhile. O(n), all cores.
    std::vector<RefitQuality> refit();

    /// Replaces the instances; trees over meshes stay. Throws as the constructor does, and then
    /// leaves the scene as it was. No query may run meanwhile. O(n log n) in the instances.
    void set_instances(std::vector<Instance> instances);

    /// Where the instances stand.
    std::span<const Placement> placements() const { return placements_; }
    bool culls_back_faces(std::size_t mesh) const { return given_[mesh].culls_back_faces; }
    std::span<const Instance> instances() const { return instances_; }
    /// As they were given.
    std::span<const SceneMesh> given_meshes() const { return given_; }
    /// In double, those that were given in float as well.
    std::span<const MeshView> meshes() const { return meshes_; }
    /// Whether queries can count their steps: with options.keep_trees or options.brute_force.
    bool counts_steps() const { return wide_trees_.size() == trees_.size(); }
    /// One a mesh, where they are kept.
    std::span<const Tree> trees() const { return trees_; }
    /// What queries walk; one a mesh, none where it is brute force.
    std::span<const WideTree> wide_trees() const { return wide_trees_; }

private:
    friend Scene open_scene(const std::filesystem::path& path, const OpenSceneOptions& options);
    /// From a file, which the owner keeps open.
    Scene(std::vector<SceneMesh> meshes, std::vector<Instance> instances,
          std::vector<WideTree> trees, BuildReport report, std::shared_ptr<const void> owner,
          bool trust);

    /// What ask(surface, tree) says of an instance, which is a MeshView or a PlacedMesh; of no tree
    /// where it is brute force.
    template <class Ask>
    auto ask_instance(std::uint32_t instance, const Ask& ask) const;
    /// Calls visit(instance, ray) for those that the ray may hit, with the ray as the instance is
    /// asked, t_max included. It returns the new t_max, as for traverse().
    template <class Visit>
    void visit_instances(const Ray& ray, const Visit& visit,
                         TraversalCounts* counts = nullptr) const noexcept;
    void add_crossings(const Ray& ray, std::vector<Hit>& hits) const;
    template <class Touching>
    std::vector<TriangleId> touching(const Box3d& box, const Touching& touching) const;

    /// The tree that rays may walk by themselves, if there is one: all of them in float, or these.
    const WideTree* only_tree() const;
    const WideTree* only_tree(std::span<const Ray> rays) const;
    void widen_vertices();
    void find_faults();
    Box3f bounds_in_world(std::uint32_t instance) const;
    void build_top();

    std::shared_ptr<const void> owner_;  ///< of the meshes' arrays, where they are the scene's own
    std::vector<SceneMesh> given_;
    std::vector<std::vector<Vec3d>> widened_;  ///< vertices that were given in float, one a mesh
    std::vector<MeshView> meshes_;
    std::vector<Instance> instances_;
    std::vector<Placement> placements_;  ///< one an instance
    std::vector<Tree> trees_;
    std::vector<WideTree> wide_trees_;
    Tree top_;  ///< over the instances
    BuildReport report_;
};

}  // namespace boxwood
