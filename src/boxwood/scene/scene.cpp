// SPDX-License-Identifier: Apache-2.0
#include "boxwood/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/round_outward.h"
#include "boxwood/tree/refit.h"

namespace boxwood {

namespace {

BuiltTree build(MeshView mesh, const SceneOptions& options) {
    if (!options.build) return build_preset(mesh, {.preset = options.preset});
    Tree tree = build_tree(mesh, *options.build);
    WideTree wide(mesh, tree);
    return {std::move(tree), std::move(wide)};
}

std::vector<Instance> one_each(std::size_t meshes) {
    std::vector<Instance> instances(meshes);
    for (std::size_t i = 0; i < meshes; ++i) instances[i].mesh = static_cast<std::uint32_t>(i);
    return instances;
}

/// Throws InvalidInput, naming the instance.
std::vector<Placement> placements_of(std::span<const Instance> instances, std::size_t meshes) {
    std::vector<Placement> placements;
    placements.reserve(instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].mesh >= meshes)
            throw InvalidInput(fmt::format("instance {}: found mesh {}, expected less than {}", i,
                                           instances[i].mesh, meshes));
        try {
            placements.emplace_back(instances[i].to_world);
        } catch (const InvalidInput& error) {
            throw InvalidInput(fmt::format("instance {}: {}", i, error.what()));
        }
    }
    return placements;
}

/// Throws InvalidInput, naming the mesh if there are several.
void check_all_indices(std::span<const MeshView> meshes) {
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        try {
            check_indices(meshes[i]);
        } catch (const InvalidInput& error) {
            if (meshes.size() == 1) throw;
            throw InvalidInput(fmt::format("mesh {}: {}", i, error.what()));
        }
    }
}

/// A box of floats around the box, or as much of it as floats can say.
Box3f rounded_outward_within_float(const Box3d& box) {
    const auto clamped = [](const Vec3d& p) -> Vec3d {
        return p.cwiseMax(-double{FLT_MAX}).cwiseMin(double{FLT_MAX});
    };
    return rounded_outward({clamped(box.lo), clamped(box.hi)});
}

}  // namespace

Scene::Scene(const std::vector<SceneMesh>& meshes, const SceneOptions& options)
    : Scene(meshes, one_each(meshes.size()), options) {}

Scene::Scene(std::vector<SceneMesh> meshes, std::vector<Instance> instances,
             const SceneOptions& options)
    : given_(std::move(meshes)), instances_(std::move(instances)) {
    placements_ = placements_of(instances_, given_.size());
    widen_vertices();
    check_all_indices(meshes_);
    find_faults();
    if (options.brute_force) return;

    for (const MeshView& mesh : meshes_) {
        BuiltTree built = build(mesh, options);
        wide_trees_.push_back(std::move(built.wide));
        if (options.keep_trees) trees_.push_back(std::move(built.tree));
    }
    build_top();
}

Scene::Scene(std::vector<SceneMesh> meshes, std::vector<Instance> instances,
             std::vector<WideTree> trees, BuildReport report, std::shared_ptr<const void> owner,
             bool trust)
    : owner_(std::move(owner)),
      given_(std::move(meshes)),
      instances_(std::move(instances)),
      wide_trees_(std::move(trees)),
      report_(std::move(report)) {
    placements_ = placements_of(instances_, given_.size());
    for (const SceneMesh& mesh : given_) meshes_.push_back(std::get<MeshView>(mesh.geometry));
    widened_.resize(given_.size());
    if (!trust) check_all_indices(meshes_);
    build_top();
}

void Scene::widen_vertices() {
    std::vector<std::vector<Vec3d>> widened(given_.size());
    std::vector<MeshView> meshes(given_.size());
    for (std::size_t i = 0; i < given_.size(); ++i) {
        if (const auto* mesh = std::get_if<MeshView>(&given_[i].geometry)) {
            meshes[i] = *mesh;
            continue;
        }
        const auto& mesh = std::get<MeshViewf>(given_[i].geometry);
        widened[i] = in_double(mesh.vertices);
        meshes[i] = {widened[i], mesh.faces};
    }
    for (std::size_t i = 0; i < wide_trees_.size(); ++i) check_refit(wide_trees_[i], meshes[i]);
    widened_ = std::move(widened);
    meshes_ = std::move(meshes);
}

void Scene::find_faults() {
    report_.meshes.clear();
    for (const MeshView& mesh : meshes_) {
        const MeshFaults none;
        report_.meshes.push_back(parallel_reduce(
            mesh.faces.size(), 4096, none,
            [&](std::size_t begin, std::size_t end) {
                MeshFaults faults;
                for (std::size_t i = begin; i < end; ++i) {
                    if (!is_in_float_range(mesh, i))
                        faults.not_finite.push_back(static_cast<std::uint32_t>(i));
                    else if (has_zero_area(mesh, i))
                        faults.zero_area.push_back(static_cast<std::uint32_t>(i));
                }
                return faults;
            },
            [](MeshFaults left, const MeshFaults& right) {
                left.not_finite.insert(left.not_finite.end(), right.not_finite.begin(),
                                       right.not_finite.end());
                left.zero_area.insert(left.zero_area.end(), right.zero_area.begin(),
                                      right.zero_area.end());
                return left;
            }));
    }
}

Box3f Scene::bounds_in_world(std::uint32_t instance) const {
    const Box3f& local = wide_trees_[instances_[instance].mesh].bounds();
    const Placement& placement = placements_[instance];
    if (local.is_empty() || placement.is_identity()) return local;
    Box3d box;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3d p;
        for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1) != 0 ? local.hi[k] : local.lo[k];
        box.extend(placement.to_world(p));
    }
    // Room for the rounding of corners here and of vertices there.
    const double size = placement.largest_in_world(largest_coordinate(local));
    const Vec3d room = Vec3d::Constant(0x1p-48 * size);
    return rounded_outward_within_float({box.lo - room, box.hi + room});
}

void Scene::build_top() {
    top_ = {};
    // A single instance needs no second tree to be found by.
    if (instances_.size() < 2 || wide_trees_.empty()) return;
    std::vector<Box3f> boxes;
    boxes.reserve(instances_.size());
    for (std::uint32_t i = 0; i < instances_.size(); ++i) boxes.push_back(bounds_in_world(i));
    top_ = build_tree(boxes);
}

Vec3d Scene::area_normal(TriangleId id) const {
    const Placement& placement = placements_[id.instance];
    const PlacedMesh placed = {meshes_[instances_[id.instance].mesh], &placement};
    const Vec3d a = placed.corner(id.triangle, 0);
    const Vec3d normal =
        (placed.corner(id.triangle, 1) - a).cross(placed.corner(id.triangle, 2) - a);
    return placement.is_mirrored() ? Vec3d(-normal) : normal;
}

Vec3d Scene::geometric_normal(TriangleId id) const { return area_normal(id).normalized(); }

std::vector<RefitQuality> Scene::refit() {
    widen_vertices();
    std::vector<RefitQuality> qualities;
    for (std::size_t i = 0; i < wide_trees_.size(); ++i)
        qualities.push_back(refit_checked(wide_trees_[i], meshes_[i]));
    for (std::size_t i = 0; i < trees_.size(); ++i)
        boxwood::refit(trees_[i], triangle_boxes(meshes_[i]));
    build_top();
    find_faults();
    return qualities;
}

void Scene::set_instances(std::vector<Instance> instances) {
    std::vector<Placement> placements = placements_of(instances, given_.size());
    instances_ = std::move(instances);
    placements_ = std::move(placements);
    build_top();
}

}  // namespace boxwood
