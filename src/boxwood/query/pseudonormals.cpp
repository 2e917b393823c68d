// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/pseudonormals.h"

#include <cmath>

#include "boxwood/core/parallel.h"
#include "boxwood/core/ray.h"
#include "boxwood/mesh/face_edges.h"
#include "boxwood/mesh/weld.h"

namespace boxwood {

namespace {

constexpr std::size_t kPiece = 4096;
constexpr std::uint32_t kNone = TriangleId::kNone;

/// The cosine of a right angle, and what rounding may add to it.
constexpr double kLean = -1e-9;

/// Of unit length, or zero where the triangle is so thin that rounding could turn it over.
Vec3d unit_normal(MeshView mesh, std::size_t face) {
    const Vec3d ab = mesh.corner(face, 1) - mesh.corner(face, 0);
    const Vec3d ac = mesh.corner(face, 2) - mesh.corner(face, 0);
    const Vec3d normal = ab.cross(ac);
    const double side = std::max(ab.squaredNorm(), ac.squaredNorm());
    constexpr double kThinnest = 1e-20;
    const double squared = normal.squaredNorm();
    if (!(squared > kThinnest * side * side)) return Vec3d::Zero();
    return normal / std::sqrt(squared);
}

double angle_at(MeshView mesh, std::size_t face, int k) {
    const Vec3d &a = mesh.corner(face, k), &b = mesh.corner(face, (k + 1) % 3),
                &c = mesh.corner(face, (k + 2) % 3);
    return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

}  // namespace

Pseudonormals::Pseudonormals(MeshView mesh) : mesh_(mesh) {
    const std::vector<std::uint32_t> names = weld(mesh.vertices);
    find_neighbours(names);
    add_up_corners(names);
    is_folded_.assign(mesh.faces.size(), 0);
    if (!is_consistent_) return;
    parallel_for(is_folded_.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            is_folded_[i] = leans_over_neighbour(static_cast<std::uint32_t>(i)) ? 1 : 0;
    });
}

bool Pseudonormals::leans_over_neighbour(std::uint32_t triangle) const {
    const Vec3d normal = unit_normal(mesh_, triangle);
    bool leans = false;
    for (const std::uint32_t neighbour : neighbours_[triangle])
        leans |= neighbour != kNone && normal.dot(unit_normal(mesh_, neighbour)) < kLean;
    return leans;
}

void Pseudonormals::find_neighbours(const std::vector<std::uint32_t>& names) {
    neighbours_.assign(mesh_.faces.size(), {kNone, kNone, kNone});
    const std::vector<FaceEdge> edges = sorted_face_edges(mesh_, names);
    is_consistent_ = !edges.empty();
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last].ends == edges[first].ends) ++last;
        const bool is_pair =
            last - first == 2 && edges[first].is_upward != edges[first + 1].is_upward;
        is_consistent_ = is_consistent_ && is_pair;
        if (!is_pair) continue;
        const FaceEdge &one = edges[first], &other = edges[first + 1];
        neighbours_[one.face][one.side] = other.face;
        neighbours_[other.face][other.side] = one.face;
    }
}

void Pseudonormals::add_up_corners(const std::vector<std::uint32_t>& names) {
    // What each corner adds takes time, and can be worked out in any order; the sums can't.
    std::vector<std::array<Vec3d, 3>> shares(mesh_.faces.size());
    parallel_for(shares.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3d normal = unit_normal(mesh_, i);
            for (int k = 0; k < 3; ++k)
                shares[i][static_cast<std::size_t>(k)] = angle_at(mesh_, i, k) * normal;
        }
    });
    std::vector<Vec3d> sums(mesh_.vertices.size(), Vec3d::Zero());
    std::vector<bool> lacks_one(mesh_.vertices.size(), false);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (triangle_box(mesh_, i).is_empty()) continue;
        for (int k = 0; k < 3; ++k) {
            const Vec3d& share = shares[i][static_cast<std::size_t>(k)];
            const std::uint32_t name = names[mesh_.faces[i][k]];
            sums[name] += share;
            if (unit_normal(mesh_, i).isZero(0)) lacks_one[name] = true;
        }
    }
    for (std::size_t i = 0; i < mesh_.faces.size() && is_consistent_; ++i) {
        const Vec3d normal = unit_normal(mesh_, i);
        for (const int vertex : mesh_.faces[i]) {
            const std::uint32_t name = names[vertex];
            if (normal.dot(sums[name]) < kLean) lacks_one[name] = true;
        }
    }
    at_vertex_.resize(mesh_.vertices.size());
    for (std::size_t i = 0; i < at_vertex_.size(); ++i)
        at_vertex_[i] = lacks_one[names[i]] ? Vec3d(Vec3d::Zero()) : sums[names[i]];
}

std::optional<Vec3d> Pseudonormals::at(std::uint32_t triangle, TrianglePart part) const noexcept {
    const auto some = [](const Vec3d& normal) -> std::optional<Vec3d> {
        if (normal.isZero(0)) return std::nullopt;
        return normal;
    };
    const int place = static_cast<int>(part);
    if (part >= TrianglePart::corner_a) return some(at_vertex_[mesh_.faces[triangle][place - 4]]);
    const Vec3d normal = unit_normal(mesh_, triangle);
    if (is_folded_[triangle] != 0 && part == TrianglePart::face) return std::nullopt;
    if (part == TrianglePart::face || normal.isZero(0)) return some(normal);
    const std::uint32_t neighbour = neighbours_[triangle][static_cast<std::size_t>(place - 1)];
    if (neighbour == kNone) return normal;
    const Vec3d other = unit_normal(mesh_, neighbour);
    if (other.isZero(0) || (is_consistent_ && normal.dot(other) < kLean)) return std::nullopt;
    return some(normal + other);
}

}  // namespace boxwood
