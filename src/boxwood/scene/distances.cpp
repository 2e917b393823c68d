// SPDX-License-Identifier: Apache-2.0
// The queries of a scene for points and shapes: those of its instances, put together.
#include <algorithm>

#include "boxwood/core/error.h"
#include "boxwood/query/brute_force.h"
#include "boxwood/query/mesh_point.h"
#include "boxwood/query/overlap_batches.h"
#include "boxwood/query/point_order.h"
#include "boxwood/scene/ask_instance.h"
#include "boxwood/scene/nearest_instances.h"

namespace boxwood {

ClosestPoint Scene::closest_near(const Vec3d& point, double max_radius,
                                 const ClosestPoint& other) const noexcept {
    ClosestPoint closest;
    if (!is_near_anything(point, max_radius)) return closest;
    double farthest = max_radius;
    const auto visit = [&](std::uint32_t instance) {
        ClosestPoint found = ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
            if (!tree)
                return closest_point_brute_force(surface, point, farthest).value_or(ClosestPoint{});
            // A place on another instance says nothing here that the radius doesn't.
            const bool is_here = other.is_found() && other.instance == instance;
            return boxwood::closest_near(surface, *tree, point, farthest,
                                         is_here ? other : ClosestPoint{});
        });
        if (!found.is_found()) return farthest;
        found.instance = instance;
        if (!closest.is_found() || is_closer(found, closest)) closest = found;
        return farthest = std::min(farthest, closest.distance);
    };
    if (!top_.is_empty()) {
        walk_nearest(top_, point, farthest, visit);
    } else {
        for (std::uint32_t i = 0; i < instances_.size(); ++i) visit(i);
    }
    return closest;
}

std::optional<ClosestPoint> Scene::closest_point(const Vec3d& point,
                                                 double max_radius) const noexcept {
    const ClosestPoint closest = closest_near(point, max_radius, {});
    if (!closest.is_found()) return std::nullopt;
    return closest;
}

void Scene::closest_points(std::span<const Vec3d> points, std::span<ClosestPoint> results,
                           double max_radius, const BatchOptions& options) const {
    if (points.size() != results.size())
        throw InvalidInput("closest_points: expected as many places for results as points");
    for_each_along_curve(points, options, [&](std::size_t i, std::size_t before) {
        results[i] = closest_near(points[i], max_radius,
                                  before == kNoPoint ? ClosestPoint{} : results[before]);
    });
}

template <class Touching>
std::vector<TriangleId> Scene::touching(const Box3d& box, const Touching& touching) const {
    std::vector<std::uint32_t> near;
    const auto visit = [&](std::uint32_t instance) {
        near.push_back(instance);
        return false;
    };
    if (!top_.is_empty()) {
        walk_touching(top_, box, visit);
    } else {
        for (std::uint32_t i = 0; i < instances_.size(); ++i) visit(i);
    }
    std::sort(near.begin(), near.end());
    std::vector<TriangleId> found;
    for (const std::uint32_t instance : near) {
        for (const std::uint32_t triangle : ask_instance(instance, touching))
            found.push_back({instance, triangle});
    }
    return found;
}

std::vector<TriangleId> Scene::box_overlap(const Box3d& box) const {
    return touching(box, [&](const auto& surface, const WideTree* tree) {
        return tree ? boxwood::box_overlap(surface, *tree, box)
                    : box_overlap_brute_force(surface, box);
    });
}

std::vector<TriangleId> Scene::sphere_overlap(const Sphere3d& sphere) const {
    if (!is_near_anything(sphere.center, sphere.radius)) return {};
    // A scene of one instance has no tree to walk by the box.
    const bool has_boxes = !top_.is_empty() && !top_.root().box.is_empty();
    const double largest = has_boxes ? largest_coordinate(top_.root().box) : 0;
    return touching(box_around(sphere, largest), [&](const auto& surface, const WideTree* tree) {
        return tree ? boxwood::sphere_overlap(surface, *tree, sphere)
                    : sphere_overlap_brute_force(surface, sphere);
    });
}

bool Scene::triangle_overlap(const TriangleCorners& triangle) const noexcept {
    if (!can_overlap(triangle)) return false;
    bool found = false;
    const auto visit = [&](std::uint32_t instance) {
        found = found || ask_instance(instance, [&](const auto& surface, const WideTree* tree) {
                    return tree ? boxwood::triangle_overlap(surface, *tree, triangle)
                                : triangle_overlap_brute_force(surface, triangle);
                });
        return found;
    };
    if (!top_.is_empty()) {
        walk_touching(top_, box_of(triangle), visit);
    } else {
        for (std::uint32_t i = 0; i < instances_.size() && !found; ++i) visit(i);
    }
    return found;
}

TriangleLists<TriangleId> Scene::box_overlaps(std::span<const Box3d> boxes,
                                              const BatchOptions& options) const {
    return overlaps_of_all<TriangleId>(boxes, options,
                                       [&](const Box3d& box) { return box_overlap(box); });
}

TriangleLists<TriangleId> Scene::sphere_overlaps(std::span<const Sphere3d> spheres,
                                                 const BatchOptions& options) const {
    return overlaps_of_all<TriangleId>(
        spheres, options, [&](const Sphere3d& sphere) { return sphere_overlap(sphere); });
}

void Scene::triangle_overlaps(std::span<const TriangleCorners> triangles, std::span<bool> results,
                              const BatchOptions& options) const {
    if (triangles.size() != results.size())
        throw InvalidInput("triangle_overlaps: expected as many places for results as triangles");
    for_each_piece(triangles.size(), kShapesOfPiece, options,
                   [&](std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                           results[i] = triangle_overlap(triangles[i]);
                   });
}

}  // namespace boxwood
