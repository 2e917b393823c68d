// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/signed_distance.h"

#include <cmath>

#include "boxwood/core/error.h"
#include "boxwood/mesh/inspect.h"
#include "boxwood/query/mesh_point.h"
#include "boxwood/query/point_order.h"
#include "boxwood/query/ray_parity.h"

namespace boxwood {

std::span<const Named<SignMethod>> sign_methods() {
    static constexpr Named<SignMethod> kMethods[] = {
        {"pseudonormal", SignMethod::pseudonormal},
        {"winding_number", SignMethod::winding_number},
        {"ray_parity", SignMethod::ray_parity},
    };
    return kMethods;
}

MeshSign::MeshSign(MeshView mesh, SignMethod method, const WindingOptions& winding)
    : mesh_(mesh), method_(method), winding_(winding) {
    switch (method) {
        case SignMethod::pseudonormal:
            normals_.emplace(mesh);
            is_trustworthy_ = normals_->is_consistent();
            break;
        case SignMethod::winding_number:
            winding_tree_.emplace(mesh);
            break;
        case SignMethod::ray_parity:
            is_trustworthy_ = is_closed(mesh);
            break;
    }
}

Side side_by_winding(double number) {
    constexpr double kFarthestFromWhole = 0.25;
    return {std::abs(number) > 0.5, std::abs(number - std::round(number)) <= kFarthestFromWhole};
}

SignedDistance with_side(const ClosestPoint& closest, const Side& side) {
    return {side.is_inside ? -closest.distance : closest.distance, !side.is_sure, closest};
}

double MeshSign::winding_number(const Vec3d& point) const noexcept {
    return boxwood::winding_number(*winding_tree_, point, winding_);
}

Side MeshSign::side_of(const WideTree& tree, const Vec3d& point,
                       const ClosestPoint& closest) const noexcept {
    // From far away rounding decides which of two triangles is nearer, but nothing has to.
    const auto outside = [&](const Box3f& box) {
        return (point.array() < box.lo.cast<double>().array()).any() ||
               (point.array() > box.hi.cast<double>().array()).any();
    };
    if (method_ != SignMethod::winding_number && is_trustworthy_ && outside(tree.bounds()))
        return {.is_inside = false, .is_sure = true};
    switch (method_) {
        case SignMethod::pseudonormal:
            return by_normal(tree, point, closest);
        case SignMethod::winding_number:
            return side_by_winding(winding_number(point));
        default:
            return by_parity(tree, point);
    }
}

Side MeshSign::by_normal(const WideTree& tree, const Vec3d& point,
                         const ClosestPoint& closest) const noexcept {
    const auto normal = normals_->at(closest.triangle, closest.part);
    if (!normal) return by_parity(tree, point);
    // A corner of the part does as well as the closest point, and isn't rounded.
    const int part = static_cast<int>(closest.part);
    const int corner = part == 0 ? 0 : (part - 1) % 3;
    return {normal->dot(point - mesh_.corner(closest.triangle, corner)) < 0, is_trustworthy_};
}

Side MeshSign::by_parity(const WideTree& tree, const Vec3d& point) const noexcept {
    const auto is_inside = is_inside_by_parity(mesh_, tree, point);
    return {is_inside.value_or(false), is_trustworthy_ && is_inside};
}

namespace {

SignedDistance with_sign(const WideTree& tree, const MeshSign& sign, const Vec3d& point,
                         const ClosestPoint& closest) noexcept {
    return with_side(closest, sign.side_of(tree, point, closest));
}

}  // namespace

std::optional<SignedDistance> signed_distance(MeshView mesh, const WideTree& tree,
                                              const MeshSign& sign, const Vec3d& point,
                                              double max_radius) noexcept {
    const auto closest = closest_point(mesh, tree, point, max_radius);
    if (!closest) return std::nullopt;
    return with_sign(tree, sign, point, *closest);
}

void signed_distances(MeshView mesh, const WideTree& tree, const MeshSign& sign,
                      std::span<const Vec3d> points, std::span<SignedDistance> results,
                      double max_radius, const BatchOptions& options) {
    if (points.size() != results.size())
        throw InvalidInput("signed_distances: expected as many places for results as points");
    for_each_along_curve(points, options, [&](std::size_t i, std::size_t before) {
        const ClosestPoint closest =
            closest_near(mesh, tree, points[i], max_radius,
                         before == kNoPoint ? ClosestPoint{} : results[before].closest);
        results[i] = {};
        if (closest.is_found()) results[i] = with_sign(tree, sign, points[i], closest);
    });
}

}  // namespace boxwood
