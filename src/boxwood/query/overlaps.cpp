// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxwood/core/error.h"
#include "boxwood/core/parallel.h"
#include "boxwood/query/kernels/ray_kernels.h"
#include "boxwood/query/mesh_point.h"

namespace boxwood {

namespace {

/// Shapes of one task.
constexpr std::size_t kPiece = 256;

Box3d in_double(const Box3f& box) { return {box.lo.cast<double>(), box.hi.cast<double>()}; }

/// The largest coordinate of the mesh.
double largest(const WideTree& tree) {
    const Box3d bounds = in_double(tree.bounds());
    return bounds.lo.cwiseAbs().cwiseMax(bounds.hi.cwiseAbs()).maxCoeff();
}

/// Visits what may touch the box, some triangles twice, until a visit says true.
/// Precondition: the box is within the bounds of the tree.
template <class Visit>
void visit_touching(const WideTree& tree, const Box3d& box, Visit visit) {
    // Corners in blocks are rounded to float.
    const double rounding = 0x1p-23 * largest(tree);
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
template <class Test>
std::vector<std::uint32_t> all_touching(const WideTree& tree, const Box3d& box, const Test& test) {
    std::vector<std::uint32_t> candidates;
    if (tree.is_empty()) return candidates;
    const Box3d part = intersection(box, in_double(tree.bounds()));
    if (part.is_empty()) return candidates;
    visit_touching(tree, part, [&](std::uint32_t triangle) {
        candidates.push_back(triangle);
        return false;
    });
    // Where a builder splits triangles, one is in several leaves.
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    const auto fails = [&](std::uint32_t triangle) { return !test(triangle); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), fails), candidates.end());
    return candidates;
}

template <class Shape, class One>
OverlapLists lists_of(std::span<const Shape> shapes, const One& one) {
    std::vector<std::vector<std::uint32_t>> found(shapes.size());
    parallel_for(shapes.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) found[i] = one(shapes[i]);
    });
    OverlapLists lists;
    lists.offsets.reserve(shapes.size() + 1);
    lists.offsets.push_back(0);
    for (const auto& list : found) lists.offsets.push_back(lists.offsets.back() + list.size());
    lists.triangles.reserve(lists.offsets.back());
    for (const auto& list : found)
        lists.triangles.insert(lists.triangles.end(), list.begin(), list.end());
    return lists;
}

}  // namespace

std::vector<std::uint32_t> box_overlap(MeshView mesh, const WideTree& tree, const Box3d& box) {
    return all_touching(tree, box, [&](std::uint32_t triangle) {
        return overlap(box, corners_of(mesh, triangle));
    });
}

std::vector<std::uint32_t> sphere_overlap(MeshView mesh, const WideTree& tree,
                                          const Sphere3d& sphere) {
    if (tree.is_empty() || !is_near_anything(sphere.center, sphere.radius)) return {};
    // A distance in double may be less than the exact one by as much.
    const double rounding =
        0x1p-46 * (sphere.radius + sphere.center.lpNorm<Eigen::Infinity>() + largest(tree));
    const Vec3d reach = Vec3d::Constant(sphere.radius + rounding);
    return all_touching(tree, {sphere.center - reach, sphere.center + reach},
                        [&](std::uint32_t triangle) {
                            return distance_to(mesh, triangle, sphere.center) <= sphere.radius;
                        });
}

bool triangle_overlap(MeshView mesh, const WideTree& tree,
                      const TriangleCorners& triangle) noexcept {
    if (tree.is_empty() || !can_overlap(triangle)) return false;
    const Box3d part = intersection(box_of(triangle), in_double(tree.bounds()));
    if (part.is_empty()) return false;
    bool found = false;
    visit_touching(tree, part, [&](std::uint32_t other) {
        found = overlap(triangle, corners_of(mesh, other));
        return found;
    });
    return found;
}

OverlapLists box_overlaps(MeshView mesh, const WideTree& tree, std::span<const Box3d> boxes) {
    return lists_of(boxes, [&](const Box3d& box) { return box_overlap(mesh, tree, box); });
}

OverlapLists sphere_overlaps(MeshView mesh, const WideTree& tree,
                             std::span<const Sphere3d> spheres) {
    return lists_of(spheres,
                    [&](const Sphere3d& sphere) { return sphere_overlap(mesh, tree, sphere); });
}

void triangle_overlaps(MeshView mesh, const WideTree& tree,
                       std::span<const TriangleCorners> triangles, std::span<bool> results) {
    if (triangles.size() != results.size())
        throw InvalidInput("triangle_overlaps: expected as many places for results as triangles");
    parallel_for(triangles.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            results[i] = triangle_overlap(mesh, tree, triangles[i]);
    });
}

}  // namespace boxwood
