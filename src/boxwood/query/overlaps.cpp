// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/overlaps.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "boxwood/core/error.h"
#include "boxwood/core/round_outward.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/mesh_point.h"
#include "boxwood/query/overlap_batches.h"

namespace boxwood {

namespace {

Box3d in_double(const Box3f& box) { return {box.lo.cast<double>(), box.hi.cast<double>()}; }

/// A box around where the mesh, as its tree sees it, may touch the box.
Box3d local_box(const MeshView& /*mesh*/, const WideTree& /*tree*/, const Box3d& box) {
    return box;
}
Box3d local_box(const PlacedMesh& placed, const WideTree& tree, const Box3d& box) {
    if (box.is_empty()) return box;
    Box3d local;
    double off = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3d p;
        // An endless box is cut where no vertex of a mesh is beyond.
        constexpr double kFarthest = 4.0 * FLT_MAX;
        for (int k = 0; k < 3; ++k)
            p[k] =
                std::clamp((corner >> k & 1) != 0 ? box.hi[k] : box.lo[k], -kFarthest, kFarthest);
        local.extend(placed.placement->to_local(p));
        off = std::max(off, placed.placement->rounding(p, largest_coordinate(tree.bounds())));
    }
    return {local.lo - Vec3d::Constant(off), local.hi + Vec3d::Constant(off)};
}

/// Visits what may touch the box, some triangles twice, until a visit says true.
/// Precondition: the box is within the bounds of the tree.
template <class Visit>
void visit_touching(const WideTree& tree, const Box3d& box, Visit visit) {
    // Corners in blocks are rounded to float.
    const double rounding = 0x1p-23 * largest_coordinate(tree.bounds());
    BoxQuery query;
    for (int k = 0; k < 3; ++k) {
        query.lo[k] = rounded_down(tree.scale() * (box.lo[k] - rounding));
        query.hi[k] = rounded_up(tree.scale() * (box.hi[k] + rounding));
    }
    const CandidateVisitor visitor = {
        .context = &visit,
        .visit = [](void* context, const std::uint32_t* triangles, unsigned mask) noexcept {
            bool is_done = false;
            for (; mask != 0 && !is_done; mask &= mask - 1)
                is_done = (*static_cast<Visit*>(context))(triangles[__builtin_ctz(mask)]);
            return is_done ? -1.0f : 0.0f;
        }};
    ray_kernels(tree.instruction_set()).walk_overlaps(tree.view(), query, visitor);
}

/// Those that may touch the box and pass the test.
template <class Surface, class Test>
std::vector<std::uint32_t> all_touching(const Surface& surface, const WideTree& tree,
                                        const Box3d& box, const Test& test) {
    std::vector<std::uint32_t> candidates;
    if (tree.is_empty()) return candidates;
    const Box3d part = intersection(local_box(surface, tree, box), in_double(tree.bounds()));
    if (part.is_empty()) return candidates;
    visit_touching(tree, part, [&](std::uint32_t triangle) {
        candidates.push_back(triangle);
        return false;
    });
    // Where a builder splits triangles, one is in several leaves.
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    const auto fails = [&](std::uint32_t triangle) {
        return !is_in_float_range(surface, triangle) || !test(triangle);
    };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), fails), candidates.end());
    return candidates;
}

template <class Surface>
std::vector<std::uint32_t> touching_box(const Surface& surface, const WideTree& tree,
                                        const Box3d& box) {
    return all_touching(surface, tree, box, [&](std::uint32_t triangle) {
        return overlap(box, corners_of(surface, triangle));
    });
}

template <class Surface>
std::vector<std::uint32_t> touching_sphere(const Surface& surface, const WideTree& tree,
                                           const Sphere3d& sphere, double largest) {
    if (tree.is_empty() || !is_near_anything(sphere.center, sphere.radius)) return {};
    return all_touching(surface, tree, box_around(sphere, largest), [&](std::uint32_t triangle) {
        return distance_to(surface, triangle, sphere.center) <= sphere.radius;
    });
}

template <class Surface>
bool touches_triangle(const Surface& surface, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept {
    if (tree.is_empty() || !can_overlap(triangle)) return false;
    const Box3d part =
        intersection(local_box(surface, tree, box_of(triangle)), in_double(tree.bounds()));
    if (part.is_empty()) return false;
    bool found = false;
    visit_touching(tree, part, [&](std::uint32_t other) {
        found = is_in_float_range(surface, other) && overlap(triangle, corners_of(surface, other));
        return found;
    });
    return found;
}

}  // namespace

std::vector<std::uint32_t> box_overlap(MeshView mesh, const WideTree& tree, const Box3d& box) {
    return touching_box(mesh, tree, box);
}
std::vector<std::uint32_t> box_overlap(const PlacedMesh& placed, const WideTree& tree,
                                       const Box3d& box) {
    return touching_box(placed, tree, box);
}

std::vector<std::uint32_t> sphere_overlap(MeshView mesh, const WideTree& tree,
                                          const Sphere3d& sphere) {
    return touching_sphere(mesh, tree, sphere, largest_coordinate(tree.bounds()));
}
std::vector<std::uint32_t> sphere_overlap(const PlacedMesh& placed, const WideTree& tree,
                                          const Sphere3d& sphere) {
    const double largest = placed.placement->largest_in_world(largest_coordinate(tree.bounds()));
    return touching_sphere(placed, tree, sphere, largest);
}

bool triangle_overlap(MeshView mesh, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept {
    return touches_triangle(mesh, tree, triangle);
}
bool triangle_overlap(const PlacedMesh& placed, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept {
    return touches_triangle(placed, tree, triangle);
}

Box3d box_around(const Sphere3d& sphere, double largest) {
    // A distance in double may be less than the exact one by as much.
    const double rounding =
        0x1p-46 * (sphere.radius + sphere.center.lpNorm<Eigen::Infinity>() + largest);
    const Vec3d reach = Vec3d::Constant(sphere.radius + rounding);
    return {sphere.center - reach, sphere.center + reach};
}

OverlapLists box_overlaps(MeshView mesh, const WideTree& tree, std::span<const Box3d> boxes,
                          const BatchOptions& options) {
    return overlaps_of_all<std::uint32_t>(
        boxes, options, [&](const Box3d& box) { return box_overlap(mesh, tree, box); });
}

OverlapLists sphere_overlaps(MeshView mesh, const WideTree& tree, std::span<const Sphere3d> spheres,
                             const BatchOptions& options) {
    return overlaps_of_all<std::uint32_t>(spheres, options, [&](const Sphere3d& sphere) {
        return sphere_overlap(mesh, tree, sphere);
    });
}

void triangle_overlaps(MeshView mesh, const WideTree& tree,
                       std::span<const TriangleCorners> triangles, std::span<bool> results,
                       const BatchOptions& options) {
    if (triangles.size() != results.size())
        throw InvalidInput("triangle_overlaps: expected as many places for results as triangles");
    for_each_piece(triangles.size(), kShapesOfPiece, options,
                   [&](std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                           results[i] = triangle_overlap(mesh, tree, triangles[i]);
                   });
}

}  // namespace boxwood
