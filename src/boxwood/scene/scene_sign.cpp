// SPDX-License-Identifier: Apache-2.0
// Which side of a mesh a point is on doesn't change when both are moved, turned or scaled, so there
// the instance asks its mesh. Other maps change angles, which pseudonormals and solid angles are
// made of; their instances get a moved copy of the mesh.
#include "boxwood/scene/scene_sign.h"

#include <cmath>
#include <map>
#include <utility>

#include "boxwood/core/error.h"
#include "boxwood/query/point_order.h"

namespace boxwood {

/// A mesh with what its signs take, and a tree for the parity of rays.
struct SceneSign::Solid {
    TriangleMesh copy;  ///< empty where the mesh is the scene's
    WideTree own_tree;
    const WideTree* tree;
    MeshView mesh;
    MeshSign sign;

    Solid(MeshView shared, const WideTree* shared_tree, SignMethod method,
          const WindingOptions& winding)
        : tree(shared_tree), mesh(shared), sign(mesh, method, winding) {
        build_tree_if_missing();
    }
    Solid(const PlacedMesh& placed, SignMethod method, const WindingOptions& winding)
        : copy(moved(placed)), tree(nullptr), mesh(copy), sign(mesh, method, winding) {
        build_tree_if_missing();
    }

private:
    static TriangleMesh moved(const PlacedMesh& placed) {
        TriangleMesh mesh;
        mesh.faces.assign(placed.mesh.faces.begin(), placed.mesh.faces.end());
        mesh.vertices.reserve(placed.mesh.vertices.size());
        for (const Vec3d& vertex : placed.mesh.vertices)
            mesh.vertices.push_back(placed.placement->to_world(vertex));
        // A mirror turns corners round, but fronts go with the instance.
        if (placed.placement->is_mirrored())
            for (Vec3i& face : mesh.faces) std::swap(face[1], face[2]);
        return mesh;
    }
    void build_tree_if_missing() {
        if (tree) return;
        own_tree = build_wide_tree(mesh);
        tree = &own_tree;
    }
};

/// How an instance is asked.
struct SceneSign::Part {
    const Solid* solid;
    const Placement* placement;  ///< nothing where the solid stands in the world
    bool is_turned;              ///< its triangles are a, c, b, not a, b, c

    Vec3d place(const Vec3d& point) const { return placement ? placement->to_local(point) : point; }
    /// A part of a triangle of the instance as the solid names it.
    TrianglePart name(TrianglePart part) const {
        if (!is_turned) return part;
        switch (part) {
            case TrianglePart::edge_ab:
                return TrianglePart::edge_ca;
            case TrianglePart::edge_ca:
                return TrianglePart::edge_ab;
            case TrianglePart::corner_b:
                return TrianglePart::corner_c;
            case TrianglePart::corner_c:
                return TrianglePart::corner_b;
            default:
                return part;
        }
    }
    Side side_of(const Vec3d& point, ClosestPoint closest) const noexcept {
        closest.part = name(closest.part);
        return solid->sign.side_of(*solid->tree, place(point), closest);
    }
};

SceneSign::SceneSign(const Scene& scene, SignMethod method, const WindingOptions& winding)
    : scene_(&scene), method_(method) {
    std::map<std::uint32_t, const Solid*> shared;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const std::uint32_t mesh = scene.instances()[i].mesh;
        const Placement& placement = scene.placements()[i];
        if (method != SignMethod::ray_parity && !placement.keeps_angles()) {
            const PlacedMesh placed = {scene.meshes()[mesh], &placement};
            solids_.push_back(std::make_unique<Solid>(placed, method, winding));
            parts_.push_back({solids_.back().get(), nullptr, placement.is_mirrored()});
            continue;
        }
        const Solid*& solid = shared[mesh];
        if (!solid) {
            const WideTree* tree = scene.wide_trees().empty() ? nullptr : &scene.wide_trees()[mesh];
            solids_.push_back(std::make_unique<Solid>(scene.meshes()[mesh], tree, method, winding));
            solid = solids_.back().get();
        }
        parts_.push_back({solid, placement.is_identity() ? nullptr : &placement, false});
    }
}

SceneSign::SceneSign(SceneSign&&) noexcept = default;
SceneSign& SceneSign::operator=(SceneSign&&) noexcept = default;
SceneSign::~SceneSign() = default;

bool SceneSign::is_trustworthy() const {
    for (const Part& part : parts_)
        if (!part.solid->tree->is_empty() && !part.solid->sign.is_trustworthy()) return false;
    return true;
}

Side SceneSign::side_of(const Vec3d& point, const ClosestPoint& closest) const noexcept {
    switch (method_) {
        case SignMethod::pseudonormal:
            return parts_[closest.instance].side_of(point, closest);
        case SignMethod::winding_number:
            return side_by_winding(winding_number(point));
        default: {
            Side all = {.is_inside = false, .is_sure = true};
            for (const Part& part : parts_) {
                if (part.solid->tree->is_empty()) continue;
                const Side side = part.side_of(point, closest);
                if (side.is_inside && side.is_sure) return side;
                all.is_inside = all.is_inside || side.is_inside;
                all.is_sure = all.is_sure && side.is_sure;
            }
            return all;
        }
    }
}

std::optional<SignedDistance> SceneSign::signed_distance(const Vec3d& point,
                                                         double max_radius) const noexcept {
    const auto closest = scene_->closest_point(point, max_radius);
    if (!closest) return std::nullopt;
    return with_side(*closest, side_of(point, *closest));
}

void SceneSign::signed_distances(std::span<const Vec3d> points, std::span<SignedDistance> results,
                                 double max_radius, const BatchOptions& options) const {
    if (points.size() != results.size())
        throw InvalidInput("signed_distances: expected as many places for results as points");
    for_each_along_curve(points, options, [&](std::size_t i, std::size_t before) {
        const ClosestPoint closest = scene_->closest_near(
            points[i], max_radius, before == kNoPoint ? ClosestPoint{} : results[before].closest);
        results[i] = {};
        if (closest.is_found()) results[i] = with_side(closest, side_of(points[i], closest));
    });
}

double SceneSign::winding_number(const Vec3d& point) const noexcept {
    double sum = 0;
    for (const Part& part : parts_) sum += part.solid->sign.winding_number(part.place(point));
    return sum;
}

void SceneSign::winding_numbers(std::span<const Vec3d> points, std::span<double> results,
                                const BatchOptions& options) const {
    if (points.size() != results.size())
        throw InvalidInput("winding_numbers: expected as many places for results as points");
    constexpr std::size_t kPiece = 256;
    for_each_piece(points.size(), kPiece, options, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) results[i] = winding_number(points[i]);
    });
}

}  // namespace boxwood
