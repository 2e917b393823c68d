// SPDX-License-Identifier: Apache-2.0
// The walk in float leaves out what is farther for sure; the few triangles that remain are decided
// in double from the mesh's own vertices. Points of a batch are answered in an order in which each
// is near the one before, whose closest point bounds its distance from the start. Explained in
// docs/algorithms/closest_point.md.
#include "boxwood/query/closest_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/core/round_outward.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/mesh_point.h"
#include "boxwood/query/point_order.h"

namespace boxwood {

namespace {

/// A point as the tree of a mesh sees it.
struct NearPoint {
    Vec3d place;
    double off = 0;     ///< it and the mesh may be by so much
    double shrink = 1;  ///< distances in the tree are at most so many times those that are meant
    double spread = 1;  ///< and vary by this factor with the direction
};

NearPoint near_point(const MeshView& /*mesh*/, const WideTree& /*tree*/, const Vec3d& point) {
    return {point};
}
NearPoint near_point(const PlacedMesh& placed, const WideTree& tree, const Vec3d& point) {
    const Placement& placement = *placed.placement;
    return {placement.to_local(point), placement.rounding(point, largest_coordinate(tree.bounds())),
            placement.most_shrinking(), placement.most_shrinking() * placement.most_growth()};
}

}  // namespace

template <class Surface>
ClosestPoint closest_near(const Surface& surface, const WideTree& tree, const Vec3d& point,
                          double max_radius, const ClosestPoint& other) noexcept {
    if (tree.is_empty() || !is_near_anything(point, max_radius)) return {};
    const auto [place, off, shrink, spread] = near_point(surface, tree, point);
    const double scale = tree.scale(), to_tree = scale * shrink;
    const Vec3d near = scale * place;
    const double reach = scale * largest_coordinate(tree.bounds()) + near.lpNorm<Eigen::Infinity>();
    // From there float can't tell any two triangles apart.
    constexpr double kFarthest = 0x1p57, kFarthestQuery = 0x1p60;
    if (!(spread * (reach + scale * off) <= kFarthest))
        return closest_point_brute_force(surface, point, max_radius).value_or(ClosestPoint{});

    MeshPoint mesh_point(surface, point, max_radius);
    PointQuery query;
    for (int k = 0; k < 3; ++k) query.point[k] = static_cast<float>(near[k]);
    query.margin = rounded_up(spread * (0x1p-21 * reach + 0x1p-61 + 4 * scale * off));
    query.reach = rounded_up(reach);
    query.spread = rounded_up(spread);
    double farthest = max_radius;
    if (other.is_found()) farthest = std::min(farthest, (point - other.point).norm());
    query.farthest = rounded_up(std::min(to_tree * farthest, kFarthestQuery));
    auto decide = [&](const std::uint32_t* triangles, unsigned mask) {
        for (; mask != 0; mask &= mask - 1) mesh_point.offer(triangles[__builtin_ctz(mask)]);
        return rounded_up(std::min(to_tree * mesh_point.farthest(), kFarthestQuery));
    };
    const CandidateVisitor visitor = {
        .context = &decide,
        .visit = [](void* context, const std::uint32_t* triangles, unsigned mask) noexcept {
            return (*static_cast<decltype(decide)*>(context))(triangles, mask);
        }};
    ray_kernels(tree.instruction_set()).walk_near_triangles(tree.view(), query, visitor);
    return mesh_point.closest();
}

template ClosestPoint closest_near(const MeshView&, const WideTree&, const Vec3d&, double,
                                   const ClosestPoint&) noexcept;
template ClosestPoint closest_near(const PlacedMesh&, const WideTree&, const Vec3d&, double,
                                   const ClosestPoint&) noexcept;

std::optional<ClosestPoint> closest_point(MeshView mesh, const WideTree& tree, const Vec3d& point,
                                          double max_radius) noexcept {
    const ClosestPoint closest = closest_near(mesh, tree, point, max_radius, {});
    if (!closest.is_found()) return std::nullopt;
    return closest;
}
std::optional<ClosestPoint> closest_point(const PlacedMesh& placed, const WideTree& tree,
                                          const Vec3d& point, double max_radius) noexcept {
    const ClosestPoint closest = closest_near(placed, tree, point, max_radius, {});
    if (!closest.is_found()) return std::nullopt;
    return closest;
}

void closest_points(MeshView mesh, const WideTree& tree, std::span<const Vec3d> points,
                    std::span<ClosestPoint> results, double max_radius,
                    const BatchOptions& options) {
    if (points.size() != results.size())
        throw InvalidInput("closest_points: expected as many places for results as points");
    for_each_along_curve(points, options, [&](std::size_t i, std::size_t before) {
        results[i] = closest_near(mesh, tree, points[i], max_radius,
                                  before == kNoPoint ? ClosestPoint{} : results[before]);
    });
}

}  // namespace boxwood
