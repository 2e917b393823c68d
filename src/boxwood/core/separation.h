// SPDX-License-Identifier: Apache-2.0
// Do two convex shapes touch? They don't when their shadows on some line are apart. Any line that
// shows a gap proves it, however it was come by, so only the shadows' own rounding has to be
// bounded: shapes that touch are never said not to. Those that are apart by no more than rounding,
// about 2^-50 of their size, may be said to touch. Constant time. Source: Gottschalk, Lin and
// Manocha, "OBBTree", SIGGRAPH 1996; Akenine-Moeller, "Fast 3D Triangle-Box Overlap Testing", JGT
// 6(1), 2001. Explained in docs/algorithms/overlaps.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "boxwood/core/box.h"
#include "boxwood/core/vec.h"

namespace boxwood {

using TriangleCorners = std::array<Vec3d, 3>;

/// Two sets of points of which lines are asked whether they show a gap.
template <std::size_t A, std::size_t B>
class Separation {
public:
    Separation(const std::array<Vec3d, A>& a, const std::array<Vec3d, B>& b) {
        // Seen from one of them, so that a place far from 0 loses no digits.
        for (std::size_t i = 0; i < A; ++i) a_[i] = a[i] - a[0];
        for (std::size_t i = 0; i < B; ++i) b_[i] = b[i] - a[0];
        for (const Vec3d& p : a_) size_ = std::max(size_, p.lpNorm<Eigen::Infinity>());
        for (const Vec3d& p : b_) size_ = std::max(size_, p.lpNorm<Eigen::Infinity>());
    }

    bool is_shown_by(const Vec3d& line) const {
        double a_lo = line.dot(a_[0]), a_hi = a_lo, b_lo = line.dot(b_[0]), b_hi = b_lo;
        for (const Vec3d& p : a_) extend(line.dot(p), a_lo, a_hi);
        for (const Vec3d& p : b_) extend(line.dot(p), b_lo, b_hi);
        const double rounding = 0x1p-50 * line.lpNorm<1>() * size_;
        return a_lo - b_hi > rounding || b_lo - a_hi > rounding;
    }

private:
    static void extend(double x, double& lo, double& hi) {
        lo = std::min(lo, x);
        hi = std::max(hi, x);
    }

    std::array<Vec3d, A> a_;
    std::array<Vec3d, B> b_;
    double size_ = 0;
};

inline Box3d box_of(const TriangleCorners& triangle) {
    const auto& [a, b, c] = triangle;
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// Whether products of its coordinates stay finite.
inline bool can_overlap(const TriangleCorners& triangle) {
    bool can = true;
    for (const Vec3d& corner : triangle) can = can && (corner.array().abs() <= 1e75).all();
    return can;
}

/// Empty where they don't touch.
inline Box3d intersection(const Box3d& a, const Box3d& b) {
    return {a.lo.cwiseMax(b.lo), a.hi.cwiseMin(b.hi)};
}

/// Whether the box, which may be infinite, and the triangle have a point in common; a triangle of
/// zero area is the segment or point that it covers. Precondition: can_overlap(triangle).
inline bool overlap(const Box3d& all, const TriangleCorners& triangle) {
    // Along the axes there is nothing to round.
    const Box3d box = intersection(all, box_of(triangle));
    if (box.is_empty()) return false;
    const auto& [a, b, c] = triangle;
    std::array<Vec3d, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? box.hi.x() : box.lo.x(), i & 2 ? box.hi.y() : box.lo.y(),
                      i & 4 ? box.hi.z() : box.lo.z()};
    const Separation separation(triangle, corners);
    const Vec3d sides[3] = {b - a, c - b, a - c};
    if (separation.is_shown_by(sides[0].cross(sides[1]))) return false;
    for (const Vec3d& side : sides) {
        for (int k = 0; k < 3; ++k)
            if (separation.is_shown_by(side.cross(Vec3d::Unit(k)))) return false;
    }
    return true;
}

/// Whether two triangles have a point in common; one of zero area is the segment or point that it
/// covers. Precondition: can_overlap() both.
inline bool overlap(const TriangleCorners& first, const TriangleCorners& second) {
    if (intersection(box_of(first), box_of(second)).is_empty()) return false;
    const Separation separation(first, second);
    const auto sides_of = [](const TriangleCorners& t) {
        return TriangleCorners{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    };
    const TriangleCorners p = sides_of(first), q = sides_of(second);
    const Vec3d p_normal = p[0].cross(p[1]), q_normal = q[0].cross(q[1]);
    if (separation.is_shown_by(p_normal) || separation.is_shown_by(q_normal)) return false;
    for (const Vec3d& side : p) {
        for (const Vec3d& other : q)
            if (separation.is_shown_by(side.cross(other))) return false;
    }
    // For triangles in one plane.
    for (std::size_t k = 0; k < 3; ++k) {
        if (separation.is_shown_by(p[k].cross(p_normal)) ||
            separation.is_shown_by(q[k].cross(q_normal)))
            return false;
    }
    // For segments and points: along each side, and from it to each corner of the other.
    for (std::size_t k = 0; k < 3; ++k) {
        if (separation.is_shown_by(p[k]) || separation.is_shown_by(q[k])) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d way = second[i] - first[k];
            if (separation.is_shown_by(way) ||
                separation.is_shown_by(p[k].cross(way).cross(p[k])) ||
                separation.is_shown_by(q[i].cross(way).cross(q[i])))
                return false;
        }
    }
    return true;
}

}  // namespace boxwood
